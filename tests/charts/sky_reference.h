// Reference values of the sky's radiance: paths of light at 40 wavelengths, with all orders of scattering.
#pragma once

#include <vector>

#include "compiler/sky/atmosphere/air.h"
#include "compiler/sky/spectrum.h"

namespace citykiln::charts {

/// Returns the luminance of a colour in linear sRGB.
inline double luminance(const sky::Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

/// Returns the radiance of the sky in a unit direction above the horizon, seen from sea level: linear sRGB, kcd/m².
///
/// Method: Monte Carlo. A path starts at the eye. Its next point is drawn in proportion to the light of 550 nm that is
/// scattered there and reaches the last point; its next direction is drawn by the phase functions. The light of the sun
/// at each point is attenuated through columns of air that are integrated anew. The method shares the description of
/// air (air.h) with the sky model and nothing else. Deterministic. Cost: 50 µs a path.
sky::Rgb reference_radiance(const sky::Air& air, Vec3 to_sun, Vec3 direction, int paths);

/// Returns the relative errors of the sky model's luminance against reference_radiance(), sorted.
/// @param rings  The number of heights from 0.5 to 88 degrees, each at six azimuths. Cost: rings · paths · 0.3 ms.
std::vector<double> sky_errors(const sky::Sky& sky, int rings, int paths, int threads);

/// Returns the share of light that passes `distance_m` of air at a height, in a direction: linear sRGB, relative to
/// sunlight. Midpoint rule with 2,000 steps at 40 wavelengths.
sky::Rgb reference_transmittance(const sky::Air& air, double height_m, Vec3 direction, double distance_m);

}  // namespace citykiln::charts

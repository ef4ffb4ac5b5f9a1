// Radiance of the sky by a long way: paths of light at 40 wavelengths, with all orders of scattering.
#pragma once

#include <vector>

#include "compiler/sky/atmosphere/air.h"
#include "compiler/sky/spectrum.h"

namespace citykiln::charts {

/// The luminance of linear sRGB.
inline double luminance(const sky::Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

/// Radiance of the sky in a unit direction above the horizon, seen from sea level: linear sRGB, kcd/m².
///
/// Method: Monte Carlo. A path starts at the eye; its next place is drawn in proportion to what scatters light of 550
/// nm there and reaches the place before, and its next direction by the phase functions. At each place the sun is seen
/// through columns of air integrated anew. It shares the description of air (air.h) with the sky model and nothing
/// else. Deterministic. Cost: 50 µs a path.
sky::Rgb reference_radiance(const sky::Air& air, Vec3 to_sun, Vec3 direction, int paths);

/// Errors of the sky model's luminance against reference_radiance(), relative; sorted.
/// @param rings  Directions: so many heights from 0.5 to 88 degrees, at six azimuths. Cost: rings · paths · 0.3 ms.
std::vector<double> sky_errors(const sky::Sky& sky, int rings, int paths, int threads);

/// The share of light that passes `distance_m` of air at a height, in a direction: linear sRGB, relative to sunlight.
/// Midpoint rule with 2,000 steps at 40 wavelengths.
sky::Rgb reference_transmittance(const sky::Air& air, double height_m, Vec3 direction, double distance_m);

}  // namespace citykiln::charts

// Preetham's analytic model of the daylight sky, for comparison with this project's.
#pragma once

#include "compiler/geometry/vec.h"
#include "compiler/sky/spectrum.h"

namespace citykiln::charts {

/// A daylight sky, prepared for radiance().
struct PreethamSky {
  Vec3 to_sun;
  /// Coefficients A to E of the Perez function, for luminance Y and chromaticities x and y.
  std::array<std::array<double, 5>, 3> coefficients{};
  sky::Rgb zenith{};  ///< Y (kcd/m²), x and y at the zenith, divided by the Perez function there.
};

/// Returns the sky for a direction to the sun (unit vector) and a turbidity (2 clear, 10 hazy).
PreethamSky preetham_sky(Vec3 to_sun, double turbidity);

/// Returns the radiance of the sky in a direction (unit vector, z >= 0), without the sun's disk: linear sRGB, kcd/m².
/// Source: Preetham, Shirley, Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999, appendix 2.
sky::Rgb radiance(const PreethamSky& sky, Vec3 direction);

}  // namespace citykiln::charts

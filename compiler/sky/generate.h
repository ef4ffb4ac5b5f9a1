// Sky model: radiance of the sky and the sun by direction.
#pragma once

#include <array>

#include "compiler/sky/recipe.h"

namespace citykiln::sky {

using Rgb = std::array<double, 3>;

/// The luminance that radiance 1 stands for: about the mean of a clear sky at noon.
inline constexpr double kUnitLuminance_cd_m2 = 6250;

/// A sky prepared for many queries. Radiances are linear RGB in kUnitLuminance_cd_m2.
struct SkyModel {
  Vec3 to_sun;
  Rgb sun_radiance;           ///< Of the sun's disk.
  double sun_cos_radius = 0;  ///< Cosine of the disk's angular radius.
  /// Coefficients A to E of the Perez function, for luminance Y and chromaticities x and y.
  std::array<std::array<double, 5>, 3> coefficients{};
  Rgb zenith{};  ///< Y (kcd/m²), x and y at the zenith, divided by the Perez function there.
};

SkyModel generate(const Sky& sky);

/// Returns the radiance of the sky in a direction (unit vector), without the sun's disk. Below the horizon it is that
/// of the horizon times 0.35, as light reflected by the ground.
Rgb radiance(const SkyModel& model, Vec3 direction);

}  // namespace citykiln::sky

// Light from a direction.
#pragma once

#include <array>

#include "compiler/sky/recipe.h"

namespace citykiln::sky {

using Rgb = std::array<double, 3>;

/// Luminance that counts as 1: about the mean of a clear sky at noon.
inline constexpr double kUnitLuminance_cd_m2 = 6250;

/// A sky made ready for many questions.
struct SkyModel {
  Vec3 to_sun;
  Rgb sun_radiance;           ///< Of the disk, linear RGB, relative units (a clear noon sky is about 1).
  double sun_cos_radius = 0;  ///< Cosine of the disk's angular radius.
  std::array<std::array<double, 9>, 3> coefficients{};
  Rgb zenith{};
};

SkyModel generate(const Sky& sky);

/// Radiance of the sky, without the sun's disk, from a unit direction; below the horizon, that of the horizon, dimmed.
Rgb radiance(const SkyModel& dome, Vec3 direction);

}  // namespace citykiln::sky

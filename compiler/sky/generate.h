// Sky model: radiance of the sky by direction, of sun and moon, and of the air between the eye and what it sees.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/sky/atmosphere/sky_dome.h"
#include "compiler/sky/atmosphere/town_glow.h"
#include "compiler/sky/recipe.h"
#include "compiler/sky/stars.h"

namespace citykiln::sky {

/// The luminance that radiance 1 stands for: about the mean of a clear sky at noon.
inline constexpr double kUnitLuminance_cd_m2 = 6250;

/// The moon as the eye sees it.
struct MoonDisk {
  Vec3 to_moon{0, 0, -1}, to_sun{0, 0, 1};  ///< Unit vectors.
  Rgb radiance{};                           ///< Of its lit part; 0 by day.
};

/// A sky prepared for many queries. Radiances are linear RGB in kUnitLuminance_cd_m2.
struct SkyModel {
  Vec3 to_sun{0, 0, 1};       ///< The light that throws shadows: the sun, or by night the moon.
  Rgb sun_radiance{};         ///< Of its disk; 0 while neither is up.
  double sun_cos_radius = 1;  ///< Cosine of the disk's angular radius.
  std::vector<std::shared_ptr<const SkyDome>> domes{};  ///< One for each source: sun, moon, both in twilight, none.
  Rgb everywhere{};    ///< Light of the sky that comes from all directions above the horizon: airglow.
  Rgb white_ground{};  ///< Radiance of level white ground at sea level.
  double ground_albedo = 0.2;
  MoonDisk moon{};
  std::vector<Star> stars{};               ///< None by day.
  std::shared_ptr<const TownGlow> glow{};  ///< Null without lamps.
};

/// @param eye_height_m  Above sea level: pictures from other heights are somewhat wrong. Cost: 0.3 s.
/// @param lamps         That are lit, for the glow of the sky (town_glow.h).
/// Guarantees: the sky's radiance is within 5 % (median) and 15 % (19 of 20 directions) of a spectral integration with
/// all orders of scattering, for suns from -3° to 60°.
SkyModel generate(const Sky& sky, double eye_height_m = 0, std::span<const GroundLight> lamps = {});

/// The radiance of the sky in a direction (unit vector), without the disks of sun and moon; below the horizon that of
/// the ground behind the air.
Rgb radiance(const SkyModel& model, Vec3 direction);

/// The radiance of level ground with the sky's albedo, at sea level.
Rgb ground_radiance(const SkyModel& model);

/// The air between the eye and what it sees in a direction.
AirPath air(const SkyModel& model, Vec3 direction, double distance_m);

}  // namespace citykiln::sky

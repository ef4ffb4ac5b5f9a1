// The sky model: the radiance of the sky by direction, of sun and moon, and of the air between the eye and a surface.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/sky/atmosphere/sky_dome.h"
#include "compiler/sky/atmosphere/town_glow.h"
#include "compiler/sky/recipe.h"
#include "compiler/sky/stars.h"

namespace citykiln::sky {

/// The luminance, in cd/m², of a radiance of 1: about the mean of a clear sky at noon.
inline constexpr double kUnitLuminance_cd_m2 = 6250;

/// The moon as the eye sees it.
struct MoonDisk {
  Vec3 to_moon{0, 0, -1}, to_sun{0, 0, 1};  ///< Unit vectors.
  Rgb radiance{};  ///< Radiance of its lit part; 0 unless it is the source of light (SkyModel::to_sun).
};

/// A sky prepared for many queries. Radiances are linear RGB in kUnitLuminance_cd_m2.
struct SkyModel {
  /// Direction to the light that throws shadows: the moon if the sun is more than 6° below the horizon, the moon's disk
  /// is above it and more than 1 % of the disk is lit; else the sun.
  Vec3 to_sun{0, 0, 1};
  Rgb sun_radiance{};         ///< Radiance of the disk in the direction to_sun; 0 if that body is below the horizon.
  double sun_cos_radius = 1;  ///< Cosine of the disk's angular radius.
  /// Tables of the sky lit by the sun, and by the moon too if to_sun is its direction.
  std::vector<std::shared_ptr<const SkyDome>> domes{};
  Rgb everywhere{};    ///< Radiance from all directions above the horizon: airglow.
  Rgb white_ground{};  ///< Radiance of level white ground at sea level.
  double ground_albedo = 0.2;
  MoonDisk moon{};
  std::vector<Star> stars{};               ///< Stars above the horizon; none by day.
  std::shared_ptr<const TownGlow> glow{};  ///< Null without lamps.
};

/// Returns the model of a sky. Cost: 0.3 s.
/// @param eye_height_m  Above sea level. The model holds for this height; pictures from others are slightly wrong.
/// @param lamps         Lamps that are lit, for sky glow (town_glow.h).
/// Guarantees: the sky's radiance is within 5 % (median) and 15 % (19 of 20 directions) of a spectral integration with
/// all orders of scattering, for suns from -3° to 60°.
SkyModel generate(const Sky& sky, double eye_height_m = 0, std::span<const GroundLight> lamps = {});

/// Returns the radiance of the sky in a direction (unit vector), without the disks of sun and moon. Below the horizon
/// it is the radiance of the ground behind the air.
Rgb radiance(const SkyModel& model, Vec3 direction);

/// Returns the radiance of level ground with the sky's albedo, at sea level.
Rgb ground_radiance(const SkyModel& model);

/// Returns the effect of the air between the eye and a surface in a direction (unit vector): the share of light that
/// passes, and the light that is added.
AirPath air(const SkyModel& model, Vec3 direction, double distance_m);

}  // namespace citykiln::sky

#include "compiler/sky/generate.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

constexpr double kUnit_kcd_m2 = kUnitLuminance_cd_m2 / 1000;

// Illuminance of the sun outside of the atmosphere, to which domes are relative.
constexpr double kSolar_lx = 128000;

// The natural sky far from towns and the Milky Way has 21.9 magnitudes per square arcsecond, half of it airglow
// (Leinert et al. 1998, "The 1997 reference of diffuse night sky brightness").
constexpr double kAirglow_cd_m2 = 1.8e-4;

// The moon counts when the sun is 6° below the horizon: before, twilight has twenty times its light.
constexpr double kDark = -0.1045;

// The brightest stars come out when the sun is 3° below the horizon.
constexpr double kStarsOut = -0.05;

// The solid angle of the disk of sun or moon.
double solid_angle_sr() { return 2 * kPi * (1 - std::cos(kSunRadius_rad)); }

// Illuminance by the moon outside of the atmosphere. Its visual magnitude by the phase angle in degrees is -12.73 +
// 0.026 |a| + 4e-9 a⁴ (Allen, "Astrophysical Quantities"); magnitude 0 is 2.54e-6 lx.
double moonlight_lx(double lit) {
  const double phase_deg = std::acos(std::clamp(2 * lit - 1, -1.0, 1.0)) * 180 / kPi;
  const double magnitude = -12.73 + 0.026 * phase_deg + 4e-9 * std::pow(phase_deg, 4);
  return 2.54e-6 * std::pow(10, -0.4 * magnitude);
}

Rgb times(const Rgb& light, double factor) { return {light[0] * factor, light[1] * factor, light[2] * factor}; }
Rgb plus(const Rgb& a, const Rgb& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

bool has_moonlight(const Sky& sky) {
  return sky.to_sun.z < kDark && sky.to_moon.z > -kSunRadius_rad && sky.moon_lit > 0.01;
}

}  // namespace

SkyModel generate(const Sky& sky, double eye_height_m, std::span<const GroundLight> lamps) {
  const LitAir lit(air_of(sky));
  SkyModel model;
  model.to_sun = unit(sky.to_sun);
  model.sun_cos_radius = std::cos(kSunRadius_rad);
  model.domes.push_back(std::make_shared<SkyDome>(lit, model.to_sun, eye_height_m, 1));
  model.moon = {.to_moon = unit(sky.to_moon), .to_sun = model.to_sun};
  if (has_moonlight(sky)) {
    const double moonlight = moonlight_lx(sky.moon_lit) / kSolar_lx;
    model.domes.push_back(std::make_shared<SkyDome>(lit, model.moon.to_moon, eye_height_m, moonlight));
    model.to_sun = model.moon.to_moon;
  }
  const SkyDome& lamp = *model.domes.back();
  model.sun_radiance = times(lamp.direct(), 1 / (kUnit_kcd_m2 * solid_angle_sr()));
  if (model.domes.size() > 1) model.moon.radiance = times(model.sun_radiance, 1 / sky.moon_lit);
  const double airglow = kAirglow_cd_m2 / kUnitLuminance_cd_m2;
  model.everywhere = {airglow, airglow, airglow};
  model.white_ground = model.everywhere;
  for (const auto& dome : model.domes)
    model.white_ground = plus(model.white_ground, times(dome->ground(), 1 / (kPi * kUnit_kcd_m2)));
  if (!lamps.empty()) {
    model.glow = std::make_shared<TownGlow>(lit.air, lamps, eye_height_m - sky.ground_m);
    model.white_ground = plus(model.white_ground, times(model.glow->ground(), 1 / (kPi * kUnit_kcd_m2)));
  }
  model.ground_albedo = sky.ground_albedo;
  if (sky.to_sun.z < kStarsOut) model.stars = stars_of(sky);
  return model;
}

Rgb ground_radiance(const SkyModel& model) { return times(model.white_ground, model.ground_albedo); }

Rgb radiance(const SkyModel& model, Vec3 direction) {
  if (direction.z < 0 && model.domes.empty()) return ground_radiance(model);
  if (direction.z < 0 && model.domes.front()->sees_sea(direction)) {
    const AirPath path = air(model, direction, model.domes.front()->sea_m(direction));
    const Rgb ground = ground_radiance(model);
    return plus(path.added, {path.passed[0] * ground[0], path.passed[1] * ground[1], path.passed[2] * ground[2]});
  }
  Rgb sum = model.everywhere;
  if (model.glow) sum = plus(sum, times(model.glow->radiance(direction), 1 / kUnit_kcd_m2));
  for (const auto& dome : model.domes) sum = plus(sum, times(dome->radiance(direction), 1 / kUnit_kcd_m2));
  return sum;
}

AirPath air(const SkyModel& model, Vec3 direction, double distance_m) {
  AirPath sum;
  for (const auto& dome : model.domes) {
    const AirPath path = dome->air(direction, distance_m);
    sum.passed = path.passed;
    sum.added = plus(sum.added, times(path.added, 1 / kUnit_kcd_m2));
  }
  return sum;
}

}  // namespace citykiln::sky

#include "compiler/sky/generate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/compiler/sky/luminance.h"

namespace citykiln::sky {
namespace {

Sky sun_at(double elevation_deg) {
  const double e = elevation_deg * std::numbers::pi / 180;
  Sky sky;
  sky.to_sun = {std::cos(e), 0, std::sin(e)};
  return sky;
}

// Illuminance of the sky on level ground, divided by π: the radiance of a white floor.
double floor_luminance(const SkyModel& dome) {
  double sum = 0;
  constexpr int kRings = 45, kSectors = 90;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSectors; ++j) {
      const double z2 = (i + 0.5) / kRings, a = 2 * std::numbers::pi * (j + 0.5) / kSectors;
      const double z = std::sqrt(z2), r = std::sqrt(1 - z2);
      sum += luminance(radiance(dome, {r * std::cos(a), r * std::sin(a), z}));
    }
  return sum / (kRings * kSectors);
}

TEST(Radiance, IsAboutOneOnAClearNoon) {
  const SkyModel dome = generate(sun_at(60));
  EXPECT_NEAR(floor_luminance(dome), 1, 0.5);
  EXPECT_NEAR(luminance(radiance(dome, {0, 0, 1})), 1, 0.5);
}

TEST(Radiance, IsBlueAwayFromTheSun) {
  const Rgb c = radiance(generate(sun_at(50)), unit(Vec3{-1, 0, 1.5}));
  EXPECT_GT(c[2], 1.3 * c[0]);
}

TEST(Radiance, IsFiniteAndNotNegativeEverywhere) {
  for (const double elevation : {-60.0, -12.0, -1.0, 0.0, 5.0, 45.0, 90.0}) {
    const SkyModel dome = generate(sun_at(elevation));
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j < 16; ++j) {
        const double z = i / 20.0 - 1, r = std::sqrt(std::max(0.0, 1 - z * z)), a = j * std::numbers::pi / 8;
        for (const double c : radiance(dome, {r * std::cos(a), r * std::sin(a), z})) {
          EXPECT_TRUE(std::isfinite(c));
          EXPECT_GE(c, 0);
          EXPECT_LT(c, 20);
        }
      }
  }
}

// A jump would be seen as a line.
TEST(Radiance, ChangesLittleFromOneDirectionToTheNext) {
  for (const double eye_m : {2.0, 1500.0}) {
    const SkyModel model = generate(sun_at(8), eye_m);
    for (const double azimuth : {0.3, 1.6, 3.1})
      for (double height = -0.06; height < 1.5; height += 0.001) {
        const auto at = [&](double h) {
          return luminance(
              radiance(model, {std::cos(h) * std::cos(azimuth), std::cos(h) * std::sin(azimuth), std::sin(h)}));
        };
        if (height < 0.0005 - std::sqrt(2 * eye_m / 6371000)) continue;  // the sea
        EXPECT_NEAR(at(height + 0.001) / at(height), 1, 0.04) << eye_m << " " << azimuth << " " << height;
      }
  }
}

TEST(Radiance, DarkensInTheNight) {
  const SkyModel noon = generate(sun_at(60));
  double before = luminance(radiance(noon, {0, 0, 1}));
  for (const double elevation : {20.0, 3.0, 0.0, -3.0, -6.0, -12.0}) {
    const double now = luminance(radiance(generate(sun_at(elevation)), {0, 0, 1}));
    EXPECT_LT(now, before) << elevation;
    before = now;
  }
}

// Under clear skies 15 to 30 % of the light of a high sun comes from the sky.
TEST(SunRadiance, IlluminatesTheGroundThreeToSevenTimesAsMuchAsTheSky) {
  const SkyModel dome = generate(sun_at(60));
  const double solid_angle = 2 * std::numbers::pi * (1 - dome.sun_cos_radius);
  const double sun = luminance(dome.sun_radiance) * solid_angle * dome.to_sun.z / std::numbers::pi;
  EXPECT_GT(sun / floor_luminance(dome), 3);
  EXPECT_LT(sun / floor_luminance(dome), 7);
}

TEST(SunRadiance, ReddensAndDimsTowardsTheHorizonAndSets) {
  const Rgb high = generate(sun_at(60)).sun_radiance, low = generate(sun_at(4)).sun_radiance;
  EXPECT_GT(low[0] / low[2], 2 * high[0] / high[2]);
  EXPECT_LT(luminance(low), 0.7 * luminance(high));
  EXPECT_EQ(luminance(generate(sun_at(-1)).sun_radiance), 0);
  EXPECT_NEAR(high[2] / high[0], 0.8, 0.2);
}

// 128 klx fall on the atmosphere; below it are 60 to 100 klx, and 300 to 1,000 lx at sunset.
TEST(WhiteGround, HasTheIlluminanceOfTheDay) {
  const auto klx = [](double elevation_deg) {
    return luminance(generate(sun_at(elevation_deg)).white_ground) * std::numbers::pi * kUnitLuminance_cd_m2 / 1000;
  };
  EXPECT_NEAR(klx(60), 97, 10);
  EXPECT_GT(klx(0), 0.3);
  EXPECT_LT(klx(0), 1.0);
  EXPECT_NEAR(std::log10(klx(-6)), std::log10(0.0034), 0.35);  // the end of civil twilight: 3.4 lx
}

TEST(Moonlight, IsThatOfAFullMoonAndThrowsShadows) {
  Sky sky = sun_at(-40);
  const SkyModel dark = generate(sky);
  EXPECT_EQ(luminance(dark.sun_radiance), 0);
  sky.to_moon = {0, 0.6, 0.8}, sky.moon_lit = 1;
  const SkyModel model = generate(sky);
  EXPECT_NEAR(model.to_sun.z, 0.8, 1e-6);
  const double lx = luminance(model.white_ground) * std::numbers::pi * kUnitLuminance_cd_m2;
  EXPECT_GT(lx, 0.1);
  EXPECT_LT(lx, 0.3);
  EXPECT_GT(luminance(radiance(model, {0, 0, 1})), 5 * luminance(radiance(dark, {0, 0, 1})));
  sky.moon_lit = 0.5;
  const double half_lx = luminance(generate(sky).white_ground) * std::numbers::pi * kUnitLuminance_cd_m2;
  EXPECT_LT(half_lx, lx / 8);  // the moon reflects back towards the sun
}

TEST(Air, HazeHidesWhatIsFarAway) {
  Sky sky = sun_at(40);
  double before = 1;
  for (const double visibility_km : {200.0, 50.0, 10.0, 2.0}) {
    sky.visibility_km = visibility_km;
    const AirPath path = air(generate(sky), {0, 1, 0}, 1000 * visibility_km / 2);
    EXPECT_NEAR(path.passed[1], std::sqrt(0.02), 0.03) << visibility_km;
    const double near = air(generate(sky), {0, 1, 0}, 1000).passed[1];
    EXPECT_LT(near, before);
    before = near;
  }
}

TEST(Air, OfAVeryLongWayIsTheSkyAtTheHorizon) {
  const SkyModel model = generate(sun_at(30), 500);
  for (const Vec3 direction : {Vec3{1, 0, 0.001}, Vec3{-1, 0, 0.001}, Vec3{0, 1, 0.001}}) {
    const double wanted = luminance(radiance(model, direction));
    EXPECT_NEAR(luminance(air(model, direction, 2e5).added) / wanted, 1, 0.1);
  }
}

}  // namespace
}  // namespace citykiln::sky

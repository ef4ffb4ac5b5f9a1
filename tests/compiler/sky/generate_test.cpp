#include "compiler/sky/generate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace citykiln::sky {
namespace {

Sky sun_at(double elevation_deg) {
  const double e = elevation_deg * std::numbers::pi / 180;
  return {"", {std::cos(e), 0, std::sin(e)}, 2.6};
}

double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

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

TEST(Radiance, DarkensBelowTheHorizonAndInTheNight) {
  const SkyModel noon = generate(sun_at(60));
  EXPECT_LT(luminance(radiance(noon, {0, -1, -0.01})), luminance(radiance(noon, {0, -1, 0})));
  double before = luminance(radiance(noon, {0, 0, 1}));
  for (const double elevation : {20.0, 3.0, 0.0, -3.0, -6.0, -12.0}) {
    const double now = luminance(radiance(generate(sun_at(elevation)), {0, 0, 1}));
    EXPECT_LT(now, before) << elevation;
    before = now;
  }
}

TEST(SunRadiance, IlluminatesTheGroundFourToTenTimesAsMuchAsTheSky) {
  const SkyModel dome = generate(sun_at(60));
  const double solid_angle = 2 * std::numbers::pi * (1 - dome.sun_cos_radius);
  const double sun = luminance(dome.sun_radiance) * solid_angle * dome.to_sun.z / std::numbers::pi;
  EXPECT_GT(sun / floor_luminance(dome), 4);
  EXPECT_LT(sun / floor_luminance(dome), 10);
}

TEST(SunRadiance, ReddensAndDimsTowardsTheHorizonAndSets) {
  const Rgb high = generate(sun_at(60)).sun_radiance, low = generate(sun_at(4)).sun_radiance;
  EXPECT_GT(low[0] / low[2], 2 * high[0] / high[2]);
  EXPECT_LT(luminance(low), 0.7 * luminance(high));
  EXPECT_EQ(luminance(generate(sun_at(-1)).sun_radiance), 0);
  EXPECT_NEAR(high[2] / high[0], 0.8, 0.2);
}

}  // namespace
}  // namespace citykiln::sky

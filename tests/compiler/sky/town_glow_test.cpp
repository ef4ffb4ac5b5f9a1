#include "compiler/sky/atmosphere/town_glow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "compiler/sky/generate.h"
#include "tests/compiler/sky/luminance.h"

namespace citykiln::sky {
namespace {

// Lamps of a round town with a density of lumen, its middle so far east of the eye.
std::vector<GroundLight> town(double lumen_per_km2, double radius_m, double east_m = 0) {
  std::vector<GroundLight> lamps;
  const double step_m = radius_m / 40;
  for (int x = -40; x <= 40; ++x)
    for (int y = -40; y <= 40; ++y)
      if (x * x + y * y <= 1600)
        lamps.push_back({{east_m + x * step_m, y * step_m}, lumen_per_km2 * step_m * step_m * 1e-6, 3000});
  return lamps;
}

double glow_cd_m2(const std::vector<GroundLight>& lamps, Vec3 direction) {
  return 1000 * luminance(TownGlow(air_of(Sky{}), lamps, 2).radiance(direction));
}

// With the natural sky of 22 magnitudes per square arcsecond.
double magnitudes(double glow_cd_m2) { return 12.58 - 2.5 * std::log10(glow_cd_m2 + 1.7e-4); }

// The ranges are those of Bortle's classes by zenith brightness: 8 and 9 in cities, 6 to 7 in towns, 4 to 5 in villages
// (Bortle 2001; Crumey, MNRAS 442, 2014). Densities of street lamps: Berlin has some 1.3 Mlm/km2.
TEST(TownGlow, ZenithIsAsBrightAsPublished) {
  const double city = magnitudes(glow_cd_m2(town(1.3e6, 12000), {0, 0, 1})),
               small_town = magnitudes(glow_cd_m2(town(0.6e6, 1500), {0, 0, 1})),
               village = magnitudes(glow_cd_m2(town(0.2e6, 400), {0, 0, 1}));
  RecordProperty("city", std::to_string(city));
  RecordProperty("town", std::to_string(small_town));
  RecordProperty("village", std::to_string(village));
  EXPECT_TRUE(city > 17 && city < 18.6) << city;
  EXPECT_TRUE(small_town > 18.6 && small_town < 20.6) << small_town;
  EXPECT_TRUE(village > 20.5 && village < 21.8) << village;
}

// Walker's law, measured 45 degrees high over towns, has a power of 2.5; in very clear air light is lost more slowly.
TEST(TownGlow, FallsWithDistanceAboutAsWalkersLaw) {
  const Vec3 kTowards{std::sqrt(0.5), 0, std::sqrt(0.5)};
  const double near = glow_cd_m2(town(1e6, 1500, 8000), kTowards), far = glow_cd_m2(town(1e6, 1500, 24000), kTowards);
  const double power = std::log(near / far) / std::log(3);
  EXPECT_GT(power, 1.7);
  EXPECT_LT(power, 3);
}

TEST(TownGlow, IsBrightestLowOverTheTown) {
  const auto lamps = town(1e6, 1500, 10000);
  const auto at = [&](double height_deg, double turn_deg) {
    const double h = height_deg * std::numbers::pi / 180, t = turn_deg * std::numbers::pi / 180;
    return glow_cd_m2(lamps, {std::cos(h) * std::cos(t), std::cos(h) * std::sin(t), std::sin(h)});
  };
  EXPECT_GT(at(10, 0), 5 * at(90, 0));
  EXPECT_GT(at(10, 0), 3 * at(10, 180));
  EXPECT_NEAR(at(10, 90), at(10, -90), 0.01 * at(10, 90));
}

TEST(TownGlow, LampsBeyondItsRadiusDoNotCount) {
  EXPECT_EQ(glow_cd_m2(town(1e6, 1000, 40000), {0, 0, 1}), 0);
  EXPECT_EQ(glow_cd_m2({}, {0, 0, 1}), 0);
}

TEST(TownGlow, LightsTheSkyAndTheGroundOfAModel) {
  Sky night;
  night.to_sun = {0, 0.8, -0.6};
  const SkyModel dark = generate(night), lit = generate(night, 2, town(1.3e6, 5000));
  EXPECT_GT(luminance(radiance(lit, {0, 0, 1})), 10 * luminance(radiance(dark, {0, 0, 1})));
  EXPECT_GT(luminance(ground_radiance(lit)), 5 * luminance(ground_radiance(dark)));
}

}  // namespace
}  // namespace citykiln::sky

#include "preview/light/inside_lights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/sky/generate.h"
#include "compiler/sky/inside/plan_inside.h"

namespace citykiln::preview {
namespace {

sky::Sky inside_sky(double visibility_km = 100, bool is_day = true) {
  sky::Sky sky;
  sky.visibility_km = visibility_km;
  sky.to_sun = is_day ? Vec3{0, 0, 1} : Vec3{0, 0.8, -0.6};
  sky.inside = sky::plan_inside({1000}, {{-1280, -3072}, {1280, 3072}});
  return sky;
}

TEST(InsideLights, SamplesAverageToTheAnalyticIrradiance) {
  const sky::Sky sky = inside_sky(300);
  const InsideLights lights(sky);
  for (const Vec3 plane : {Vec3{0, 0, 0}, Vec3{600, 900, 40}, Vec3{-1000, -2500, 10}}) {
    const map::BentPoint at = map::at(sky.inside->cylinder, plane);
    double sum = 0;
    constexpr int kSide = 256;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j)
        if (const auto drawn = lights.sample(at.at, at.up, {(i + 0.5) / kSide, (j + 0.5) / kSide}))
          sum += luminance(drawn->light) * std::max(0.0, dot(at.up, drawn->direction));
    const double lux = sum / (kSide * kSide) * sky::kUnitLuminance_cd_m2;
    const double expected = sky::daylight_lx(*sky.inside, plane);
    // a little is lost in clear air
    EXPECT_LT(lux, expected);
    EXPECT_GT(lux, 0.94 * expected);
  }
}

TEST(InsideLights, ByNightThereIsNone) {
  const InsideLights lights(inside_sky(100, false));
  EXPECT_FALSE(lights.are_lit());
  EXPECT_FALSE(lights.sample({0, 0, 10}, {0, 0, 1}, {0.5, 0.5}).has_value());
  EXPECT_EQ(luminance(lights.hull({0, 0, 10}, unit(Vec3{0.1, 0.7, 0.7})).radiance), 0);
  const sky::AirPath air = lights.air({0, 0, 10}, {0, 0, 1}, 1900);
  EXPECT_EQ(luminance(air.added), 0);
  EXPECT_LT(air.passed[2], air.passed[0]);
}

TEST(InsideLights, RaysMeetTubesAndTheHull) {
  const sky::Sky sky = inside_sky();
  const InsideLights lights(sky);
  const sky::LineLight& line = sky.inside->lines[5];
  const Vec3 on = map::at(sky.inside->cylinder, {(line.from.x + line.to.x) / 2, line.from.y, line.from.z}).at;
  const Vec3 from{on.x, 30, 400};
  const auto tube = lights.tube(from, unit(on - from));
  ASSERT_TRUE(tube.has_value());
  EXPECT_NEAR(tube->distance_m, length(on - from) - line.radius_m, 1e-3);
  EXPECT_FALSE(lights.tube(from, unit(from - on)).has_value());
  // the far side and an end
  EXPECT_NEAR(lights.hull({0, 0, 500}, {0, 0, 1}).distance_m, 1500, 1e-9);
  EXPECT_NEAR(lights.hull({0, 0, 500}, {1, 0, 0}).distance_m, sky.inside->east_m, 1e-9);
}

// The error is that of the points of quadrature, of which parts of a way have more.
TEST(InsideLights, LightOfTheAirIsThatOfManyParts) {
  const sky::Sky sky = inside_sky(20);
  const InsideLights lights(sky);
  for (const Vec3 direction : {Vec3{0, 0.1, 1}, Vec3{1, 0.3, 0.2}, Vec3{0.2, -1, 0.3}, Vec3{1, 0, 0}}) {
    const Vec3 from{100, -20, 60}, along = unit(direction);
    const double distance_m = lights.hull(from, along).distance_m * 0.9;
    Rgb sum{}, passed{1, 1, 1};
    constexpr int kParts = 64;
    for (int i = 0; i < kParts; ++i) {
      const sky::AirPath part = lights.air(from + along * (distance_m * i / kParts), along, distance_m / kParts);
      sum = sum + passed * part.added, passed = passed * part.passed;
    }
    const sky::AirPath whole = lights.air(from, along, distance_m);
    EXPECT_NEAR(luminance(whole.added), luminance(sum), 0.01 * luminance(sum));
    EXPECT_NEAR(luminance(whole.passed), luminance(passed), 1e-6);
    EXPECT_GT(luminance(sum), 0);
  }
}

}  // namespace
}  // namespace citykiln::preview

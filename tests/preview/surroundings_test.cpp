#include "preview/light/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "preview/light/light.h"

namespace citykiln::preview {
namespace {

Surroundings plain_at(double height_m) {
  return {.centre = {100, 0}, .height_m = height_m, .ring = {{{0.2, 0.3, 0.1}, 0}, {{}, 1}, {{0.4, 0.4, 0.4}, 0}, {}}};
}

TEST(MeetGround, IsASphereAboutTheEarth) {
  // the horizon of an eye 100 m up is at sqrt(2 · 6371 km · 100 m) = 35.7 km, 0.00560 rad below level
  EXPECT_FALSE(meet_ground(plain_at(20), {0, 0, 120}, unit(Vec3{1, 0, -0.00559})));
  const auto far = meet_ground(plain_at(20), {0, 0, 120}, unit(Vec3{1, 0, -0.00561}));
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->distance_m, 35700, 2500);
  const auto near = meet_ground(plain_at(20), {5, 7, 120}, {0, 0, -1});
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->distance_m, 100, 1e-6);
  EXPECT_EQ(near->place, (Vec2{5, 7}));
  EXPECT_FALSE(meet_ground(plain_at(20), {0, 0, 120}, {1, 0, 0}));
}

TEST(MeetGround, IsBelowEyesThatAreBelowThePlain) {
  const auto met = meet_ground(plain_at(500), {0, 0, 120}, unit(Vec3{1, 0, -0.1}));
  ASSERT_TRUE(met);
  EXPECT_GT(met->distance_m, 10);
  EXPECT_LT(met->distance_m, 20);
}

TEST(EdgeAt, IsInterpolatedByAzimuth) {
  const Surroundings around = plain_at(0);
  EXPECT_EQ(edge_at(around, {200, 0}).albedo[1], 0.3);  // east
  EXPECT_EQ(edge_at(around, {100, 50}).sea, 1);         // north
  EXPECT_NEAR(edge_at(around, {150, 50}).sea, 0.5, 1e-9);
}

// Where the ground around ends, the eye must not see an edge by a hazy day.
TEST(Seen, TheGroundAroundFadesIntoTheSkyAtTheHorizon) {
  sky::Sky sky;
  sky.to_sun = unit(Vec3{-0.5, -0.4, 0.7}), sky.visibility_km = 15;
  const Lights lights(sky::generate(sky, 200), {}, plain_at(0));
  const double dip = std::sqrt(2 * 200 / 6371000.0);
  for (const Vec2 at : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-0.6, -0.8}}) {
    const auto seen = [&](double z) {
      return luminance(lights.seen({0, 0, 200}, unit(at_height(at, z)), 0.001, true));
    };
    EXPECT_NEAR(seen(-dip - 0.0005) / seen(-dip + 0.0005), 1, 0.1);
    // land below is darker than hazy air
    EXPECT_LT(seen(-0.5), seen(-dip + 0.0005));
  }
}

}  // namespace
}  // namespace citykiln::preview

#include "preview/light/surroundings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "preview/light/light.h"

namespace citykiln::preview {
namespace {

Surroundings plain_at(double height_m) {
  const Edge grass{{0.2, 0.3, 0.1}, 0, height_m}, sea{{}, 1, height_m}, sand{{0.4, 0.4, 0.4}, 0, height_m};
  const std::vector<Edge> ring = {grass, sea, sand, sea};
  return {.box = {{-100, -100}, {300, 100}}, .ring = ring, .mean = mean_of(ring)};
}

TEST(MeetGround, IsASphereAboutTheEarth) {
  // the horizon of an eye 100 m up is at sqrt(2 · 6371 km · 100 m) = 35.7 km, 0.00560 rad below level
  EXPECT_FALSE(meet_ground(plain_at(20), {300, 0, 120}, unit(Vec3{1, 0, -0.00559})));
  const auto far = meet_ground(plain_at(20), {300, 0, 120}, unit(Vec3{1, 0, -0.00561}));
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->distance_m, 35700, 2500);
  EXPECT_FALSE(meet_ground(plain_at(20), {0, 0, 120}, {1, 0, 0}));
}

TEST(MeetGround, IsBeyondTheBox) {
  // 300 m to the box's side, 30 m lower; from there 70 m down
  const auto met = meet_ground(plain_at(20), {0, 0, 120}, unit(Vec3{1, 0, -0.1}));
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->distance_m, 1000 * std::sqrt(1.01), 2);
  EXPECT_NEAR(met->edge.albedo[1], 0.3, 0.03);
  // below the edge's height: where it leaves the box
  const auto low = meet_ground(plain_at(500), {0, 0, 120}, unit(Vec3{1, 0, -0.1}));
  ASSERT_TRUE(low);
  EXPECT_NEAR(low->distance_m, 300 * std::sqrt(1.01), 2);
  // an eye outside that looks towards it from far away: the ground on this side
  const auto far = meet_ground(plain_at(20), {-5000, 0, 120}, unit(Vec3{1, 0, -0.1}));
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->distance_m, 1000 * std::sqrt(1.01), 2);
  EXPECT_NEAR(far->edge.albedo[1], 0.4, 0.1);
  // an eye outside that looks away from it
  const auto away = meet_ground(plain_at(20), {400, 0, 120}, unit(Vec3{1, 0, -0.1}));
  ASSERT_TRUE(away);
  EXPECT_NEAR(away->distance_m, 1000 * std::sqrt(1.01), 2);
}

// Knowing the range of heights makes it faster, and moves no point by more than a ten thousandth of its distance.
TEST(MeetGround, IsTheSameWithBoundedHeights) {
  Surroundings hills = plain_at(100);
  hills.ring[0].height_m = 300, hills.ring[3].height_m = 20, hills.mean = mean_of(hills.ring);
  Surroundings bounded = hills;
  bound_heights(bounded);
  EXPECT_EQ(bounded.lowest_m, 20);
  EXPECT_EQ(bounded.highest_m, 300);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const double turn = 2.4 * i, dip = 0.05 + 0.0005 * (i % 400);
    const Vec3 from{50.0 * (i % 7), 0, 10.0 + 37 * (i % 31)}, down = unit({std::cos(turn), std::sin(turn), -dip});
    const auto slow = meet_ground(hills, from, down), fast = meet_ground(bounded, from, down);
    ASSERT_EQ(slow.has_value(), fast.has_value()) << i;
    if (!slow) continue;
    EXPECT_NEAR(fast->distance_m, slow->distance_m, 3e-4 * slow->distance_m) << i;
    ++met;
  }
  EXPECT_GT(met, 500);
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
  }
}

}  // namespace
}  // namespace citykiln::preview

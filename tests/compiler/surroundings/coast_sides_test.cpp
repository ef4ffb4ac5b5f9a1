#include "compiler/surroundings/coast_sides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace citykiln::surroundings {
namespace {

// Clockwise round the middle: the land of a coast is on its left, so this has land outside, as a bay has.
Polyline circle(Vec2 middle, double radius_m, int points, bool is_island) {
  Polyline ring;
  for (int i = 0; i <= points; ++i) {
    const double turn = 2 * 3.14159265358979 * (i % points) / points * (is_island ? 1 : -1);
    ring.push_back(middle + Vec2{std::cos(turn), std::sin(turn)} * radius_m);
  }
  return ring;
}

TEST(CoastSides, LandIsInIslandsAndSeaInBays) {
  for (const bool is_island : {true, false}) {
    const std::vector<Polyline> coasts = {circle({500, -200}, 1000, 40, is_island)};
    const CoastSides sides(coasts);
    std::mt19937 dice(7);
    std::uniform_real_distribution<double> place(-4000, 4000);
    for (int i = 0; i < 2000; ++i) {
      const Vec2 p{place(dice), place(dice)};
      const double away_m = std::abs(distance(p, {500, -200}) - 1000);
      if (away_m < 10) continue;
      const auto side = sides.at(p);
      ASSERT_TRUE(side);
      EXPECT_EQ(side->is_sea, (distance(p, {500, -200}) > 1000) == is_island) << p.x << " " << p.y;
      EXPECT_NEAR(side->away_m, away_m, 4);
      EXPECT_FALSE(side->is_beyond);
    }
  }
}

TEST(CoastSides, AtASharpCapeBothSidesOfItsTipAreSea) {
  // land is a spike to the east; places before its tip are nearest to the vertex that both segments share
  const std::vector<Polyline> coasts = {{{-1000, -10}, {0, 0}}, {{0, 0}, {-1000, 10}}};
  const CoastSides sides(coasts);
  for (const Vec2 p : {Vec2{5, 0}, {50, 40}, {50, -40}, {2, 30}, {2, -30}}) EXPECT_TRUE(sides.at(p)->is_sea) << p.y;
  for (const double x : {-900.0, -300.0, -20.0}) EXPECT_FALSE(sides.at({x, 0})->is_sea) << x;
}

TEST(CoastSides, BeyondTheirEndsCoastsGoOnStraight) {
  const std::vector<Polyline> coasts = {{{0, 0}, {1000, 0}}, {{1000, 0}, {2000, 500}}};
  const CoastSides sides(coasts);
  EXPECT_TRUE(sides.at({-5000, -1})->is_sea);
  EXPECT_FALSE(sides.at({-5000, 1})->is_sea);
  EXPECT_TRUE(sides.at({-5000, 1})->is_beyond);
  EXPECT_FALSE(sides.at({1000, 20})->is_beyond);
  EXPECT_TRUE(sides.at({4000, 1400})->is_sea);
  EXPECT_FALSE(sides.at({4000, 1600})->is_sea);
}

TEST(CoastSides, WithoutCoastsThereIsNoSide) {
  EXPECT_FALSE(CoastSides({}).at({0, 0}));
  const std::vector<Polyline> points = {{{1, 1}}, {}};
  EXPECT_TRUE(CoastSides(points).is_empty());
}

}  // namespace
}  // namespace citykiln::surroundings

#include "compiler/buildings/planning/party_walls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/buildings/made_footprint.h"

namespace citykiln::buildings {
namespace {

// A row of three, the middle one set back by 4 m, and one that stands alone.
std::vector<map::Footprint> row() {
  return {rectangle(1, {0, 0}, 8, 10, 9), rectangle(2, {8, 4}, 8, 10, 9), rectangle(3, {16, 0}, 8, 10, 9),
          rectangle(4, {24.5, 0}, 8, 10, 9)};
}

TEST(PartyWalls, AreWhereWallsRunTogether) {
  const auto shared = shared_walls(row());
  ASSERT_EQ(shared[0].size(), 1u);
  EXPECT_EQ(shared[0][0].edge, 1u);
  EXPECT_EQ(shared[0][0].from_m, 4);
  EXPECT_EQ(shared[0][0].to_m, 10);
  EXPECT_EQ(shared[0][0].neighbour, 1u);
  EXPECT_TRUE(shared[0][0].is_coplanar);
  EXPECT_EQ(shared[1].size(), 2u);
  EXPECT_EQ(shared[2].size(), 1u);
  EXPECT_TRUE(shared[3].empty());
}

TEST(PartyWalls, HaveTheSameLengthFromBothSides) {
  const auto shared = shared_walls(row());
  double lengths_m[3] = {};
  for (int i = 0; i < 3; ++i)
    for (const SharedWall& wall : shared[i]) lengths_m[i] += wall.to_m - wall.from_m;
  EXPECT_EQ(lengths_m[0] + lengths_m[2], lengths_m[1]);
}

TEST(PartyWalls, AreNotCoplanarAcrossAGap) {
  const auto shared = shared_walls(std::vector{rectangle(1, {0, 0}, 8, 10, 9), rectangle(2, {8.047, 0}, 8, 10, 9)});
  ASSERT_EQ(shared[0].size(), 1u);
  EXPECT_FALSE(shared[0][0].is_coplanar);
}

TEST(PartyWalls, AreNoneForTouchingCornersAndEqualRings) {
  // a vertex on a wall; two equal rings
  const auto corner = shared_walls(
      std::vector{rectangle(1, {0, 0}, 8, 10, 9), footprint_on(2, {{8, 5}, {12, 1}, {16, 5}, {12, 9}}, 9)});
  EXPECT_TRUE(corner[0].empty());
  const auto twice = shared_walls(std::vector{rectangle(1, {0, 0}, 8, 10, 9), rectangle(2, {0, 0}, 8, 10, 9)});
  EXPECT_TRUE(twice[0].empty());
}

TEST(PartyWalls, IgnoreOutlinesWithParts) {
  std::vector<map::Footprint> footprints = row();
  footprints[1].has_parts = true;
  EXPECT_TRUE(shared_walls(footprints)[0].empty());
}

TEST(PartyWalls, AreInCourtyardsToo) {
  map::Footprint around = rectangle(1, {0, 0}, 30, 30, 9);
  around.polygon.holes = {{{10, 10}, {10, 20}, {20, 20}, {20, 10}}};
  const auto shared = shared_walls(std::vector{around, rectangle(2, {10, 10}, 4, 5, 9)});
  EXPECT_EQ(shared[1].size(), 2u);
  EXPECT_TRUE(shared[0].empty());  // only edges of outer rings are listed
}

// Too large an angle, a gap of 0.1 m, an overlap of 0.2 m.
TEST(PartyWalls, AreNoneForOtherAnglesGapsAndShortOverlaps) {
  const map::Footprint house = rectangle(1, {0, 0}, 8, 10, 9);
  const map::Footprint turned = footprint_on(2, {{8.05, 5.3}, {8, 5}, {12, 5}, {12, 5.3}}, 9);
  for (const map::Footprint& other : {turned, rectangle(2, {8.1, 0}, 8, 10, 9), rectangle(2, {8, 9.8}, 8, 10, 9)})
    EXPECT_TRUE(shared_walls(std::vector{house, other})[0].empty());
}

}  // namespace
}  // namespace citykiln::buildings

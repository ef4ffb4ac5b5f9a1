#include "compiler/roads/pieces/islands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/roads/network.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;

Road street_without_pavements(std::int64_t id, Polyline axis) { return made_road(id, std::move(axis), 6); }

// Two streets and a slip lane between them.
std::vector<Road> with_slip_lane(double side_m) {
  return {street_without_pavements(1, {{0, 0}, {side_m, 0}, {100, 0}}),
          street_without_pavements(2, {{0, -100}, {0, 0}, {0, side_m}, {0, 100}}),
          street_without_pavements(3, {{side_m, 0}, {0, side_m}})};
}

TEST(Islands, LieBetweenSlipLanesAndTheirStreets) {
  const auto islands = islands_of(with_slip_lane(20));
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0].surface, LandCoverClass::kIsland);
  EXPECT_DOUBLE_EQ(signed_area_m2(islands[0].ring), 200);
}

TEST(Islands, AreSmallerThanBlocks) { EXPECT_TRUE(islands_of(with_slip_lane(30)).empty()); }

TEST(Islands, AreNotMadeByYards) {
  std::vector<Road> roads = with_slip_lane(20);
  roads[2].surface = LandCoverClass::kServiceRoad;
  EXPECT_TRUE(islands_of(roads).empty());
}

TEST(Islands, WithinLargeRoundaboutsArePlanted) {
  Road ring = street_without_pavements(1, {{15, 0}, {0, 15}, {-15, 0}, {0, -15}, {15, 0}});
  ring.is_roundabout = true;
  const Road arm = street_without_pavements(2, {{15, 0}, {100, 0}});
  const auto islands = islands_of(std::vector{ring, arm});
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0].surface, LandCoverClass::kVerge);
}

TEST(Islands, DoNotDependOnTheOrderOfRoads) {
  std::vector<Road> roads = with_slip_lane(20);
  const auto islands = islands_of(roads);
  std::ranges::reverse(roads);
  const auto again = islands_of(roads);
  ASSERT_EQ(again.size(), islands.size());
  EXPECT_EQ(again[0].id, islands[0].id);
}

TEST(Islands, HaveNoDeadEndsInThem) {
  std::vector<Road> roads = with_slip_lane(20);
  roads.push_back(street_without_pavements(4, {{0, 0}, {4, 4}}));
  // the ring would run along the dead end and back: it touches itself, so it is no island
  EXPECT_TRUE(islands_of(roads).empty());
}

TEST(Islands, ATurningLoopHasARaisedIslandAndAMiniRoundaboutAPaintedCircle) {
  Road loop = street_without_pavements(1, {{0, 0}, {50, 0}}), mini = street_without_pavements(2, {{0, 90}, {50, 90}});
  loop.points = {{1, map::TrackPointKind::kTurningLoop, 0}};
  mini.points = {{0, map::TrackPointKind::kMiniRoundabout, 0}};
  const auto islands = islands_of(std::vector{loop, mini});
  ASSERT_EQ(islands.size(), 2u);
  EXPECT_EQ(islands[0].surface, LandCoverClass::kTrafficIsland);
  EXPECT_NEAR(signed_area_m2(islands[0].ring), 3.06 * kLoopIsland_m * kLoopIsland_m, 0.1);
  EXPECT_EQ(islands[1].surface, LandCoverClass::kPaintedIsland);
}

TEST(Islands, ATurningCircleHasNone) {
  Road circle = street_without_pavements(1, {{0, 0}, {50, 0}});
  circle.points = {{1, map::TrackPointKind::kTurningCircle, 0}};
  EXPECT_TRUE(islands_of(std::vector{circle}).empty());
}

TEST(Islands, ANodeOfSeveralStreetsHasOneIsland) {
  Road a = street_without_pavements(2, {{0, 0}, {50, 0}}), b = street_without_pavements(1, {{50, 0}, {50, 40}});
  a.points = {{1, map::TrackPointKind::kTurningLoop, 0}}, b.points = {{0, map::TrackPointKind::kTurningLoop, 0}};
  const auto islands = islands_of(std::vector{a, b});
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0].id.osm.id, 1);
}

}  // namespace
}  // namespace citykiln::roads

#include "compiler/furniture/road_things.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::furniture {
namespace {

const Box2 kRoadTile{{0, 0}, {512, 512}};

// A street of two lanes with a crossing that has an island.
roads::Road crossed_with_island(double lane_m) {
  roads::Road road =
      roads::made_road(1, {{100, 100}, {200, 100}, {300, 100}}, lane_m, map::LandCoverClass::kTertiaryRoad, 2, 2);
  map::Lane back = road.section.lanes[1];
  road.section.lanes[1].way = map::LaneDirection::kForward, back.way = map::LaneDirection::kBackward;
  road.section.lanes.insert(road.section.lanes.begin() + 1, back);
  road.section.axis_offset_m = lane_m;
  road.points = {{.vertex = 1, .kind = map::TrackPointKind::kZebra, .traits = map::kCrossingIsland}};
  return road;
}

std::vector<things::Thing> refuges_of(const roads::Road& road) {
  const std::vector<roads::Road> roads = {road};
  const ground::LandCoverIndex index = ground::index_land_cover({}, kRoadTile);
  return refuges({.roads = roads,
                  .junctions = {},
                  .yards = {},
                  .pitches = {},
                  .trunks = {},
                  .things = {},
                  .lamps = {},
                  .barriers = {},
                  .buildings = {},
                  .land_cover = index,
                  .tile_m = 512},
                 kRoadTile);
}

TEST(Refuges, StandBeforeAndBehindACrossingWithAnIsland) {
  const std::vector<things::Thing> made = refuges_of(crossed_with_island(4));
  ASSERT_EQ(made.size(), 2u);
  for (const things::Thing& refuge : made) {
    EXPECT_NEAR(refuge.at.y, 100, 0.01);
    EXPECT_NEAR(std::abs(refuge.at.x - 200), 2 + refuge.form.depth_m / 2, 0.01);
  }
}

TEST(Refuges, NeedRoomAndAMappedIsland) {
  EXPECT_TRUE(refuges_of(crossed_with_island(3)).empty());
  roads::Road plain = crossed_with_island(4);
  plain.points[0].traits = 0;
  EXPECT_TRUE(refuges_of(plain).empty());
}

}  // namespace
}  // namespace citykiln::furniture

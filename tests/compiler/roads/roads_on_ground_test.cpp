#include "compiler/roads/roads_on_ground.h"

#include <gtest/gtest.h>

namespace citykiln::roads {
namespace {

map::Track way_through_0_0(std::int64_t id, Polyline axis, map::LandCoverClass surface, double width_m) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  track.axis = std::move(axis);
  track.node_ids = {id * 10, 1, id * 10 + 2};
  track.surface = surface;
  track.section = {{{.width_m = width_m}}, width_m / 2};
  track.is_rail = map::values_of(surface).group == map::LandCoverGroup::kRail;
  return track;
}

// The length of rails on either side of a level crossing that is covered.
double reach_m(map::Track way) {
  map::Features features;
  features.tracks = {way_through_0_0(1, {{-50, 0}, {0, 0}, {50, 0}}, map::LandCoverClass::kRailway, 4), std::move(way)};
  features.tracks[0].points = {{.vertex = 1, .kind = map::TrackPointKind::kLevelCrossing}};
  Report report;
  return roads_on_ground(features, report).at(0).points.at(0).reach_quarters / 4.0;
}

TEST(RoadsOnGround, RailsAreCoveredAsWideAsTheWayThatCrossesThem) {
  using map::LandCoverClass;
  EXPECT_NEAR(reach_m(way_through_0_0(2, {{0, -9}, {0, 0}, {0, 9}}, LandCoverClass::kPavedFootPath, 2)), 1.25, 0.01);
  EXPECT_NEAR(reach_m(way_through_0_0(2, {{0, -9}, {0, 0}, {0, 9}}, LandCoverClass::kPrimaryRoad, 12)), 6.25, 0.01);
  // an oblique way covers more
  EXPECT_NEAR(reach_m(way_through_0_0(2, {{-9, -9}, {0, 0}, {9, 9}}, LandCoverClass::kPavedFootPath, 2)), 3, 0.01);
}

TEST(RoadsOnGround, ACrossingThatNoWayOnTheGroundHasIsLeftToTheUsualLength) {
  map::Track bridge = way_through_0_0(2, {{0, -9}, {0, 0}, {0, 9}}, map::LandCoverClass::kPrimaryRoad, 12);
  bridge.passage = map::Passage::kBridge;
  EXPECT_EQ(reach_m(bridge), 0);
}

}  // namespace
}  // namespace citykiln::roads

#include "compiler/assume/fit_widths.h"

#include <gtest/gtest.h>

#include "compiler/roads/roads_on_ground.h"

namespace citykiln::assume {
namespace {

using map::Lane;
using map::LaneDirection;
using map::LaneKind;
using roads::left_m;
using roads::right_m;
using roads::Road;
using roads::road_of;

// A street along the x axis, two lanes of 2.75 m in its middle.
map::Track two_lane_track(double long_m = 100) {
  map::Track track;
  track.id = {{OsmType::kWay, 1}, 0};
  track.axis = {{0, 0}, {long_m, 0}};
  track.surface = map::LandCoverClass::kResidentialRoad;
  track.section.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, 2.75},
                         {LaneKind::kDriving, LaneDirection::kForward, 2.75}};
  track.section.axis_offset_m = 2.75;
  return track;
}

// The two-lane track with a row of parked cars on its right.
map::Track parked_street() {
  map::Track track = two_lane_track();
  track.section.lanes.push_back({LaneKind::kParking, LaneDirection::kForward, 2});
  return track;
}

map::PointFeature thing(std::int64_t id, Vec2 at) {
  map::PointFeature point;
  point.id = {{OsmType::kNode, id}, 0};
  point.at = at, point.kind = map::PointKind::kTree;
  return point;
}

Road fitted(map::Track track, std::vector<map::PointFeature> points, std::vector<map::Barrier> barriers = {},
            std::vector<map::ThingFeature> things = {}) {
  map::Features features;
  features.things = std::move(things);
  features.tracks = {std::move(track)};
  features.points = std::move(points), features.barriers = std::move(barriers);
  return road_of(fit_assumed_widths(features).front());
}

map::Barrier wall(Polyline axis) {
  map::Barrier barrier;
  barrier.id = {{OsmType::kWay, 9}, 0};
  barrier.axis = std::move(axis);
  barrier.kind = map::BarrierKind::kWall, barrier.width_m = 0.25;
  return barrier;
}

TEST(FitAssumedWidths, LanesNarrowBetweenTreesOnBothSides) {
  const Road road = fitted(two_lane_track(), {thing(1, {20, 2.9}), thing(2, {70, -2.8})});
  EXPECT_LE(left_m(road), 2.9 - kTreeFromKerb_m + 0x1p-9);
  EXPECT_LE(right_m(road), 2.8 - kTreeFromKerb_m + 0x1p-9);
  EXPECT_GE(width_m(road), 4.5);
}

TEST(FitAssumedWidths, TheCarriagewayMovesAwayFromATreeOnOneSide) {
  const Road road = fitted(two_lane_track(), {thing(1, {50, 2})});
  EXPECT_LE(left_m(road), 2 - kTreeFromKerb_m + 0x1p-9);
  EXPECT_EQ(width_m(road), 5.5);
}

TEST(FitAssumedWidths, ParkingNarrowsBeforeLanes) {
  const Road road = fitted(parked_street(), {thing(1, {50, 3.25}), thing(2, {50, -5})});
  ASSERT_EQ(road.section.lanes.size(), 3u);
  EXPECT_EQ(road.section.lanes[0].width_m, 2.75);
  EXPECT_EQ(road.section.lanes[1].width_m, 2.75);
  EXPECT_LT(road.section.lanes[2].width_m, 2);
}

TEST(FitAssumedWidths, AThickWallBesideTheAxisIsOneThatCrossesTheWay) {
  map::Barrier city_wall = wall({{10, 1.5}, {90, 1.5}});
  city_wall.width_m = 4;
  const Road road = fitted(two_lane_track(), {}, {city_wall});
  EXPECT_EQ(left_m(road), 2.75);
  EXPECT_EQ(right_m(road), 2.75);
}

TEST(FitAssumedWidths, TheAxisStaysOnTheCarriageway) {
  for (int i = 0; i < 400; ++i) {
    const Vec2 left{20, 1 + 0.01 * i}, right{70, -1 - 0.007 * ((i * 7) % 400)};
    const Road road = fitted(parked_street(), {thing(1, left), thing(2, right)});
    EXPECT_GE(left_m(road), 0);
    EXPECT_GE(right_m(road), 0);
  }
}

TEST(FitAssumedWidths, WallsAndHydrantsLimitTheWidthToo) {
  const Road road = fitted(two_lane_track(), {}, {wall({{10, -2.6}, {90, -2.6}})},
                           {{.id = {{OsmType::kNode, 1}, 0}, .at = {50, 2.6}, .kind = "hydrant", .value = ""}});
  EXPECT_LE(left_m(road), 2.6 - kThingFromKerb_m + 0x1p-9);
  EXPECT_LE(right_m(road), 2.6 - kThingFromKerb_m - 0.125 + 0x1p-9);
}

TEST(FitAssumedWidths, TaggedWidthsAndPlacementsStay) {
  map::Track wide = two_lane_track(), placed = two_lane_track();
  wide.has_tagged_width = placed.has_tagged_placement = true;
  EXPECT_EQ(width_m(fitted(wide, {thing(1, {50, 2}), thing(2, {50, -2})})), 5.5);
  const Road road = fitted(placed, {thing(1, {50, 2.8})});
  EXPECT_EQ(left_m(road), right_m(road));
  EXPECT_LE(left_m(road), 2.8 - kTreeFromKerb_m + 0x1p-9);
}

TEST(FitAssumedWidths, ThingsInTheRoadAndBeyondItsEndsSayNothing) {
  EXPECT_EQ(fitted(two_lane_track(), {thing(1, {50, 0.5}), thing(2, {-1, 2}), thing(3, {50, 9})}),
            road_of(two_lane_track()));
  EXPECT_EQ(fitted(two_lane_track(), {}, {wall({{50, -20}, {50, 20}})}), road_of(two_lane_track()));
  // both cannot stand beside a lane of the least width for each direction
  EXPECT_GE(width_m(fitted(two_lane_track(), {thing(1, {50, 1.2}), thing(2, {50, -1.2})})), 4.5);
}

TEST(FitAssumedWidths, WaysBeyondTheRadiusStay) {
  EXPECT_EQ(width_m(fitted(two_lane_track(kLongestFitted_m + 1), {thing(1, {50, 2.8}), thing(2, {50, -2.8})})), 5.5);
}

TEST(FitAssumedWidths, TheOrderOfThingsDoesNotMatter) {
  const std::vector<map::PointFeature> there = {thing(1, {20, 2.9}), thing(2, {70, -2.8}), thing(3, {30, 1.1})};
  EXPECT_EQ(fitted(parked_street(), there), fitted(parked_street(), {there.rbegin(), there.rend()}));
}

}  // namespace
}  // namespace citykiln::assume

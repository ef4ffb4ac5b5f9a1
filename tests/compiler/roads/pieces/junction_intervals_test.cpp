#include <gtest/gtest.h>

#include "compiler/roads/junctions/through_road.h"
#include "compiler/roads/pieces/stretches.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;

// A main road along x that a side road meets at x = 100 m.
std::vector<Road> meeting(LandCoverClass side, std::vector<map::TrackPoint> main_points = {}) {
  std::vector<Road> roads = {made_road(1, {{0, 0}, {100, 0}, {200, 0}}, 8, LandCoverClass::kPrimaryRoad),
                             made_road(2, {{100, 0}, {100, 100}}, 6, side)};
  roads[0].points = std::move(main_points);
  return roads;
}

std::vector<Junction> junctions_of(const std::vector<Road>& roads) {
  Report report;
  return plan_junctions(roads, report);
}

bool goes_through(const std::vector<Road>& roads) {
  const auto junctions = junctions_of(roads);
  return junctions.size() == 1 && has_through_road(junctions[0], roads, arms_of(junctions, roads)[0]);
}

TEST(ThroughRoad, PassesLesserRoads) {
  EXPECT_TRUE(goes_through(meeting(LandCoverClass::kResidentialRoad)));
  EXPECT_FALSE(goes_through(meeting(LandCoverClass::kPrimaryRoad)));
}

TEST(ThroughRoad, StopsAtSignals) {
  EXPECT_FALSE(goes_through(meeting(LandCoverClass::kResidentialRoad, {{1, map::TrackPointKind::kSignals, 0}})));
}

TEST(ThroughRoad, IsOfOneWidth) {
  std::vector<Road> roads = meeting(LandCoverClass::kResidentialRoad);
  roads[0].axis = {{0, 0}, {100, 0}};
  roads.push_back(made_road(3, {{100, 0}, {200, 0}}, 12, LandCoverClass::kPrimaryRoad));
  EXPECT_FALSE(goes_through(roads));
}

TEST(JunctionIntervals, ARoadThatGoesThroughHasNone) {
  const std::vector<Road> roads = meeting(LandCoverClass::kResidentialRoad);
  const auto intervals = junction_intervals_of(roads, junctions_of(roads));
  EXPECT_TRUE(intervals[0].empty());
  ASSERT_EQ(intervals[1].size(), 1u);
  EXPECT_EQ(intervals[1][0].at_m, 0);
  EXPECT_GT(intervals[1][0].after_m, 4);
  // the minor road gives way
  EXPECT_EQ(intervals[1][0].after, Control::kGiveWay);
}

TEST(JunctionIntervals, SignalsApplyToAllArms) {
  const std::vector<Road> roads = meeting(LandCoverClass::kResidentialRoad, {{1, map::TrackPointKind::kSignals, 0}});
  const auto intervals = junction_intervals_of(roads, junctions_of(roads));
  ASSERT_EQ(intervals[0].size(), 1u);
  EXPECT_EQ(intervals[0][0].at_m, 100);
  EXPECT_EQ(intervals[0][0].before, Control::kSignals);
  EXPECT_EQ(intervals[0][0].after, Control::kSignals);
  EXPECT_EQ(intervals[1][0].after, Control::kSignals);
}

TEST(JunctionIntervals, ASignAppliesToTrafficThatFacesIt) {
  std::vector<Road> roads = meeting(LandCoverClass::kPrimaryRoad);
  // on the side road, 15 m before the junction, for traffic towards it, which runs against the way
  roads[1].axis = {{100, 0}, {100, 15}, {100, 100}};
  roads[1].points = {{1, map::TrackPointKind::kStop, -1}};
  EXPECT_EQ(junction_intervals_of(roads, junctions_of(roads))[1][0].after, Control::kStop);
  roads[1].points[0].facing = 1;
  EXPECT_EQ(junction_intervals_of(roads, junctions_of(roads))[1][0].after, Control::kNone);
}

TEST(JunctionIntervals, WhereOnlyTheWidthChangesHaveNoControl) {
  const std::vector<Road> roads = {made_road(1, {{0, 0}, {100, 0}}, 8, LandCoverClass::kPrimaryRoad),
                                   made_road(2, {{100, 0}, {200, 0}}, 12, LandCoverClass::kPrimaryRoad)};
  const auto intervals = junction_intervals_of(roads, junctions_of(roads));
  ASSERT_EQ(intervals[0].size(), 1u);
  EXPECT_TRUE(intervals[0][0].is_change);
}

}  // namespace
}  // namespace citykiln::roads

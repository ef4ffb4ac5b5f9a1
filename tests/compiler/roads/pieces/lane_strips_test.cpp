#include "compiler/roads/pieces/lane_strips.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/compiler/roads/made_road.h"
#include "tests/compiler/roads/markings/marking_layout_text.h"

namespace citykiln::roads {
namespace {

// A road with these lanes, its axis in the middle of the carriageway.
Road road_of_lanes(const std::string& left, const std::string& middle, const std::string& right) {
  Road road = made_road(1, {{0, 0}, {100, 0}}, 1);
  road.section.lanes.clear();
  for (const auto& [part, is_raised] : {std::pair(left, true), std::pair(middle, false), std::pair(right, true)})
    for (const char letter : part)
      road.section.lanes.push_back(
          {kind_of(letter), map::LaneDirection::kBoth, usual_width_m(kind_of(letter)), 0, is_raised});
  road.section.axis_offset_m = map::carriageway_width_m(road.section) / 2;
  return road;
}

std::string surfaces_of(const std::vector<LaneStrip>& strips) {
  std::vector<std::string_view> names;
  for (const LaneStrip& strip : strips) names.push_back(map::values_of(strip.surface).name);
  return fmt::format("{}", fmt::join(names, " "));
}

TEST(LaneStrips, AreRunsOfOneSurfaceWithKerbsBetween) {
  EXPECT_EQ(surfaces_of(lane_strips_of(road_of_lanes("s", "pddcp", "cs"), 0.02)),
            "Pavement Kerb ParkingLane ResidentialRoad ParkingLane Kerb CycleTrack Pavement");
  EXPECT_EQ(surfaces_of(lane_strips_of(road_of_lanes("", "dd", ""), 0.02)), "ResidentialRoad");
}

TEST(LaneStrips, VergesAreStripsOfTheirOwnAndRaisedBuffersPavement) {
  EXPECT_EQ(surfaces_of(lane_strips_of(road_of_lanes("sg", "dd", "g"), 0.02)),
            "Pavement Verge Kerb ResidentialRoad Kerb Verge");
  EXPECT_EQ(surfaces_of(lane_strips_of(road_of_lanes("", "dd", "g/cs"), 0.02)),
            "ResidentialRoad Kerb Verge Pavement CycleTrack Pavement");
  const auto strips = lane_strips_of(road_of_lanes("sg", "dd", ""), 0.02);
  EXPECT_DOUBLE_EQ(strips[1].left_m - strips[1].right_m, usual_width_m(map::LaneKind::kVerge) - kKerb_m);
}

TEST(LaneStrips, LieEdgeToEdgeAndAsWideAsTheirLanes) {
  for (const char* middle : {"d", "pddp", "Sdd/c"})
    for (const char* side : {"", "s", "cs", "g", "gs"}) {
      const Road road = road_of_lanes(side, middle, side);
      const auto strips = lane_strips_of(road, 0.02);
      ASSERT_FALSE(strips.empty());
      EXPECT_DOUBLE_EQ(strips.front().left_m, left_m(road) + raised_left_m(road));
      EXPECT_DOUBLE_EQ(strips.back().right_m, -right_m(road) - raised_right_m(road));
      for (std::size_t i = 1; i < strips.size(); ++i) EXPECT_DOUBLE_EQ(strips[i].left_m, strips[i - 1].right_m);
      for (const LaneStrip& strip : strips) EXPECT_GT(strip.left_m, strip.right_m);
    }
}

TEST(LaneStrips, NarrowerThanTheToleranceYieldInwards) {
  EXPECT_EQ(surfaces_of(lane_strips_of(road_of_lanes("s", "dd", "s"), 0.2)), "Pavement ResidentialRoad Pavement");
  const auto strips = lane_strips_of(road_of_lanes("s", "dd", "s"), 0.2);
  EXPECT_DOUBLE_EQ(strips[0].right_m - strips[1].left_m, 0);
  EXPECT_EQ(surfaces_of(lane_strips_of(road_of_lanes("s", "dd", "s"), 9)), "ResidentialRoad");
}

}  // namespace
}  // namespace citykiln::roads

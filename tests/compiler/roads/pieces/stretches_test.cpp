#include "compiler/roads/pieces/stretches.h"

#include <gtest/gtest.h>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

constexpr double kStretchTile_m = 4096;

Road straight(double length_m) {
  return made_road(1, {{100, 100}, {100 + length_m, 100}}, 7, map::LandCoverClass::kPrimaryRoad);
}

JunctionInterval junction_at(double at_m, double reach_m) {
  return {at_m, reach_m, reach_m, Control::kStop, Control::kGiveWay};
}

// "along 0-80, end 80-92 …"
std::string text_of_stretches(const std::vector<RoadStretch>& runs) {
  constexpr const char* kNames[] = {"along", "start", "end", "zebra", "crossing", "level", "hump", "table", "cushions"};
  std::string text;
  for (const RoadStretch& run : runs)
    text += (text.empty() ? "" : ", ") + std::string(kNames[static_cast<int>(run.stretch)]) + " " +
            std::to_string(static_cast<int>(run.from_m)) + "-" + std::to_string(static_cast<int>(run.to_m));
  return text;
}

TEST(Stretches, APlainRoadIsOne) {
  EXPECT_EQ(text_of_stretches(stretches_of(straight(200), {}, kStretchTile_m)), "along 0-200");
}

TEST(Stretches, RoadsEndAtJunctionsWithTheirApproach) {
  const std::vector<JunctionInterval> intervals = {junction_at(0, 8), junction_at(200, 10)};
  const auto runs = stretches_of(straight(200), intervals, kStretchTile_m);
  EXPECT_EQ(text_of_stretches(runs), "along 0-8, start 8-20, along 20-178, end 178-190, along 190-200");
  EXPECT_EQ(runs[1].control, Control::kGiveWay);
  EXPECT_EQ(runs[3].control, Control::kStop);
  // the stop line is at the end of the road
  EXPECT_EQ(runs[3].zero_m + kLayoutLength_m, runs[3].to_m);
  EXPECT_EQ(runs[1].zero_m, runs[1].from_m);
}

TEST(Stretches, ShortBlocksAreShared) {
  const std::vector<JunctionInterval> intervals = {junction_at(0, 8), junction_at(30, 8)};
  EXPECT_EQ(text_of_stretches(stretches_of(straight(30), intervals, kStretchTile_m)),
            "along 0-8, start 8-15, end 15-22, along 22-30");
  const std::vector<JunctionInterval> close = {junction_at(0, 8), junction_at(20, 8)};
  EXPECT_EQ(text_of_stretches(stretches_of(straight(20), close, kStretchTile_m)), "along 0-20");
}

TEST(Stretches, NoApproachWhereOnlyTheWidthChanges) {
  std::vector<JunctionInterval> intervals = {junction_at(0, 8), junction_at(30, 1)};
  intervals[1].is_change = true;
  EXPECT_EQ(text_of_stretches(stretches_of(straight(60), intervals, kStretchTile_m)),
            "along 0-8, start 8-20, along 20-60");
}

TEST(Stretches, ACrossingInAJunctionIsMovedToItsMouth) {
  Road road = made_road(1, {{100, 100}, {104, 100}, {300, 100}}, 7, map::LandCoverClass::kPrimaryRoad);
  road.points = {{1, map::TrackPointKind::kZebra, 0}};
  const std::vector<JunctionInterval> intervals = {junction_at(0, 8)};
  EXPECT_EQ(text_of_stretches(stretches_of(road, intervals, kStretchTile_m)),
            "along 0-8, zebra 8-12, along 12-13, start 13-25, along 25-200");
}

TEST(Stretches, CrossingsMidwayStayWhereTheyAre) {
  Road road = made_road(1, {{100, 100}, {150, 100}, {300, 100}}, 7, map::LandCoverClass::kPrimaryRoad);
  road.points = {{1, map::TrackPointKind::kCrossing, 0}};
  EXPECT_EQ(text_of_stretches(stretches_of(road, {}, kStretchTile_m)), "along 0-48, crossing 48-52, along 52-200");
  road.surface = map::LandCoverClass::kFootPath;
  EXPECT_EQ(text_of_stretches(stretches_of(road, {}, kStretchTile_m)), "along 0-200");
}

TEST(Stretches, HumpsAreDrawnMidwayButNotOnACrossing) {
  Road road = made_road(1, {{100, 100}, {150, 100}, {300, 100}}, 7, map::LandCoverClass::kPrimaryRoad);
  road.points = {{1, map::TrackPointKind::kHump, 0}};
  EXPECT_EQ(text_of_stretches(stretches_of(road, {}, kStretchTile_m)), "along 0-48, hump 48-52, along 52-200");
  road.points = {{1, map::TrackPointKind::kZebra, 0}, {1, map::TrackPointKind::kSpeedTable, 0}};
  EXPECT_EQ(text_of_stretches(stretches_of(road, {}, kStretchTile_m)), "along 0-48, zebra 48-52, along 52-200");
}

TEST(Stretches, RailsKnowWhereRoadsCrossThem) {
  Road road = made_road(1, {{100, 100}, {150, 100}, {300, 100}}, 4, map::LandCoverClass::kRailway);
  road.points = {{1, map::TrackPointKind::kLevelCrossing, 0}};
  EXPECT_EQ(text_of_stretches(stretches_of(road, {}, kStretchTile_m)), "along 0-45, level 45-54, along 54-200");
}

// Two tiles that an approach touches must both know what it depends on, or neither draws it.
TEST(Stretches, ApproachesAcrossABorderNeedBothTilesToKnowThem) {
  const std::vector<JunctionInterval> intervals = {junction_at(0, 8)};
  const auto is_drawn = [&](double x) {
    const Road road = made_road(1, {{x, 100}, {x + 200, 100}}, 7, map::LandCoverClass::kPrimaryRoad);
    return stretches_of(road, intervals, 1024).size() > 1;
  };
  EXPECT_TRUE(is_drawn(100));
  // the approach crosses x = 1024, and what it depends on extends 40 m from the junction
  EXPECT_TRUE(is_drawn(1024 - 14));
  EXPECT_FALSE(is_drawn(1024 - 7));
  EXPECT_TRUE(is_drawn(1024 - 40));
}

}  // namespace
}  // namespace citykiln::roads

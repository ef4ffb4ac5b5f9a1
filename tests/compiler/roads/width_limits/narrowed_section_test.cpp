#include "compiler/roads/width_limits/narrowed_section.h"

#include <gtest/gtest.h>

#include <numeric>
#include <tuple>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

// A street of 6 m with pavements of 2 m, and a building so far from its middle on the left.
Road street_beside_building(double half_m) {
  Road road = made_road(1, {{0, 0}, {200, 0}}, 6, map::LandCoverClass::kResidentialRoad, 2, 2);
  road.width_limits.left = {{100, half_m, false}};
  return road;
}

void expect_edges(const Road& road, double along_m, RoadEdges wanted) {
  const RoadEdges e = road_edges_at(road, along_m);
  EXPECT_DOUBLE_EQ(e.left_m, wanted.left_m);
  EXPECT_DOUBLE_EQ(e.kerb_left_m, wanted.kerb_left_m);
  EXPECT_DOUBLE_EQ(e.kerb_right_m, wanted.kerb_right_m);
  EXPECT_DOUBLE_EQ(e.right_m, wanted.right_m);
}

TEST(NarrowedSection, TakesPavementThenCarriagewayThenTheRestOfThePavement) {
  expect_edges(street_beside_building(4.5), 100, {4.5, 3, 3, 5});
  expect_edges(street_beside_building(3.5), 100, {3.5, 3, 3, 5});
  expect_edges(street_beside_building(2.5), 100, {2.5, 2, 3, 5});
  expect_edges(street_beside_building(1.75), 100, {1.75, 1.25, 3, 5});
  expect_edges(street_beside_building(1.5), 100, {1.5, 1.25, 3, 5});
  expect_edges(street_beside_building(0.5), 100, {1.25, 1.25, 3, 5});
}

TEST(NarrowedSection, OpensByOneInEight) {
  expect_edges(street_beside_building(4.5), 102, {4.75, 3, 3, 5});
  expect_edges(street_beside_building(4.5), 96, {5, 3, 3, 5});
  expect_edges(street_beside_building(4.5), 0, {5, 3, 3, 5});
  EXPECT_EQ(max_offsets_at(street_beside_building(4.5), 92).left_m, 5.5);
  EXPECT_GT(max_offsets_at(street_beside_building(4.5), 92).right_m, 1e9);
}

TEST(NarrowedSection, RunsStraightAlongWalls) {
  Road road = street_beside_building(4.5);
  road.width_limits.left.push_back({140, 3.5, true});
  EXPECT_DOUBLE_EQ(max_offsets_at(road, 120).left_m, 4);
  EXPECT_DOUBLE_EQ(max_offsets_at(road, 144).left_m, 4);
}

TEST(NarrowedSection, IsAboutTheMiddleOfTheCarriagewayWhereverTheAxisLies) {
  Road road = street_beside_building(0.5);
  road.section.axis_offset_m = 0;
  expect_edges(road, 100, {-1.75, -1.75, 6, 8});
}

TEST(NarrowedSection, LeavesAPathOneMetre) {
  Road path = made_road(1, {{0, 0}, {200, 0}}, 2, map::LandCoverClass::kFootPath);
  path.section.lanes.front().kind = map::LaneKind::kFoot;
  path.width_limits.right = {{100, 0.25, false}};
  expect_edges(path, 100, {1, 1, 0.5, 0.5});
}

TEST(NarrowedLanes, AddUpToTheEdgesAndAreContinuous) {
  using map::Lane, map::LaneKind, map::LaneDirection;
  Road road = street_beside_building(0.5);
  const auto lane = [](LaneKind kind, double width_m, bool is_raised) {
    return Lane{kind, LaneDirection::kBoth, width_m, 0, is_raised};
  };
  road.section = {
      {lane(LaneKind::kSidewalk, 2, true), lane(LaneKind::kBuffer, 0.5, true), lane(LaneKind::kCycle, 1.5, true),
       lane(LaneKind::kParking, 2, false), lane(LaneKind::kDriving, 3, false), lane(LaneKind::kDriving, 3, false),
       lane(LaneKind::kShoulder, 1, false), lane(LaneKind::kSidewalk, 2, true)},
      4};
  road.width_limits.right = {{90, 0.5, false}};
  std::vector<double> before;
  for (double along = 0; along <= 200; along += 0.125) {
    const NarrowedSection s = narrowed_section_at(road, along);
    const RoadEdges e = road_edges_at(road, along);
    ASSERT_DOUBLE_EQ(s.left_m, e.left_m);
    ASSERT_NEAR(std::accumulate(s.widths_m.begin(), s.widths_m.end(), 0.0), e.left_m + e.right_m, 1e-9);
    ASSERT_NEAR(std::accumulate(s.widths_m.begin(), s.widths_m.begin() + 3, 0.0), e.left_m - e.kerb_left_m, 1e-9);
    for (std::size_t i = 0; i < before.size(); ++i)
      ASSERT_LE(std::abs(s.widths_m[i] - before[i]), 2 * kTaper * 0.125 + 1e-9);
    before = s.widths_m;
  }
  // the buffer before the pavement, the shoulder before driving
  road.width_limits = {{{100, 8.25, false}}, {{100, 4.5, false}}};
  EXPECT_EQ(narrowed_section_at(road, 100).widths_m, (std::vector<double>{2, 0.25, 1.5, 2, 3, 3, 0.5, 0.5}));
}

// The street with a verge outside of its left pavement and one inside of its right one.
Road street_with_verges(double half_m) {
  Road road = street_beside_building(half_m);
  const map::Lane verge{map::LaneKind::kVerge, map::LaneDirection::kBoth, 1, 0, true};
  road.section.lanes.insert(road.section.lanes.begin(), verge);
  road.section.lanes.insert(road.section.lanes.end() - 1, verge);
  return road;
}

TEST(NarrowedLanes, VergesGiveWayBeforePavements) {
  Road road = street_with_verges(5.5);
  road.width_limits.right = {{100, 4.5, false}};
  EXPECT_EQ(narrowed_section_at(road, 100).widths_m, (std::vector<double>{0.5, 2, 6, 0, 1.5}));
}

TEST(NarrowedSectionBends, AreWhereAVergeOutsideAPavementIsUsedUp) {
  const Road road = street_with_verges(3.25);
  EXPECT_EQ(paved_left_m(road), 2);
  EXPECT_EQ(paved_right_m(road), 3);
  const auto paved_m = [&](double along_m) {
    const RoadEdges edges = road_edges_at(road, along_m);
    return std::min(edges.left_m, edges.kerb_left_m + paved_left_m(road));
  };
  const std::vector<double> bends = bends_of_edges(road);
  for (std::size_t i = 1; i < bends.size(); ++i)
    EXPECT_NEAR(paved_m((bends[i - 1] + bends[i]) / 2), (paved_m(bends[i - 1]) + paved_m(bends[i])) / 2, 1e-9);
}

TEST(NarrowedSectionBends, AreWhereEdgesTurn) {
  Road road = street_beside_building(1);
  road.width_limits.left.push_back({120, 3, false});
  const std::vector<double> bends = bends_of_edges(road);
  std::vector<double> corners = {0};
  corners.insert(corners.end(), bends.begin(), bends.end());
  corners.push_back(200);
  ASSERT_GT(corners.size(), 4u);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double from = std::clamp(corners[i - 1], 0.0, 200.0), to = std::clamp(corners[i], 0.0, 200.0);
    const RoadEdges a = road_edges_at(road, from), b = road_edges_at(road, to),
                    mid = road_edges_at(road, (from + to) / 2);
    ASSERT_NEAR(mid.left_m, (a.left_m + b.left_m) / 2, 1e-9) << from << " " << to;
    ASSERT_NEAR(mid.kerb_left_m, (a.kerb_left_m + b.kerb_left_m) / 2, 1e-9) << from << " " << to;
  }
}

}  // namespace
}  // namespace citykiln::roads

#include "compiler/roads/generate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/network.h"
#include "compiler/roads/trim.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

Road road_of_6_m(Polyline axis, double left_m = 0, double right_m = 0) {
  return made_road(1, std::move(axis), 6, map::LandCoverClass::kResidentialRoad, left_m, right_m);
}

std::vector<Ring> stroke_of(const Road& road) { return stroke(carriageway_of(road)); }

double rings_area_m2(const std::vector<Ring>& rings) {
  std::vector<OwnedSegment> segments;
  for (const Ring& ring : rings) add_ring(segments, ring, 0);
  double area = 0;
  const auto owned = overlay(segments, 1);
  for (const Polygon& polygon : owned[0]) area += area_m2(polygon);
  return area;
}

TEST(RoadStrip, CoversItsAxisAsWideAsItIs) {
  EXPECT_DOUBLE_EQ(rings_area_m2(stroke_of(road_of_6_m({{0, 0}, {100, 0}}))), 600);
  // a right bend to the left: the inner corner counts once, the outer one is filled
  EXPECT_NEAR(rings_area_m2(stroke_of(road_of_6_m({{0, 0}, {100, 0}, {110, 50}}))), 6 * (100 + std::sqrt(2600.0)), 0.2);
}

TEST(SixteenGon, LiesWithinItsCircleByLessThanTwoPerCent) {
  const Ring ring = sixteen_gon({8, -4}, 10);
  ASSERT_EQ(ring.size(), 16u);
  EXPECT_GT(signed_area_m2(ring), 0);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    EXPECT_NEAR(distance(ring[i], {8, -4}), 10, 0.001);
    EXPECT_EQ(ring[i], snapped(ring[i]));
    const Vec2 middle = (ring[i] + ring[(i + 1) % ring.size()]) * 0.5;
    EXPECT_GT(distance(middle, {8, -4}), 9.8);
  }
}

TEST(RoadStrip, IsMadeOfCounterClockwiseRings) {
  const std::vector<Ring> rings = stroke_of(road_of_6_m({{0, 0}, {20, 3}, {5, 9}, {40, 9}, {41, 60}}));
  EXPECT_EQ(rings.size(), 7u) << "a quad for each segment and a ring for each bend";
  for (const Ring& ring : rings) EXPECT_GT(signed_area_m2(ring), 0);
}

TEST(RoadStrip, LiesAboutItsAxisAsItsLanesDo) {
  Road shifted = road_of_6_m({{0, 0}, {100, 0}});
  shifted.section.axis_offset_m = 1;
  EXPECT_EQ(box_of(stroke_of(shifted).front()), (Box2{{0, -5}, {100, 1}}));
}

TEST(RoadStrip, IsJoinedToWhereItGoesOn) {
  const double apart = rings_area_m2(stroke_of(road_of_6_m({{0, 0}, {100, 0}}))),
               bent = apart + 9 * std::tan(0.25 * std::acos(-1.0) / 2);
  const Vec2 beyond{200, 100};
  EXPECT_NEAR(rings_area_m2(stroke(carriageway_of(road_of_6_m({{0, 0}, {100, 0}})), {false, {}, beyond})), bent, 9);
  // both halves of the joint make a whole without a gap
  std::vector<Ring> both = stroke(carriageway_of(road_of_6_m({{0, 0}, {100, 0}})), {false, {}, beyond});
  for (Ring& ring : stroke(carriageway_of(road_of_6_m({{100, 0}, beyond})), {false, Vec2{0, 0}, {}}))
    both.push_back(ring);
  EXPECT_NEAR(rings_area_m2(both), rings_area_m2(stroke_of(road_of_6_m({{0, 0}, {100, 0}, beyond}))), 0.01);
}

TEST(RoadsEnds, JoinWhereTwoMeetAndNoMore) {
  const std::vector<Road> two = {road_of_6_m({{0, 0}, {100, 0}}), road_of_6_m({{100, 0}, {200, 9}})};
  const std::vector<StripEnds> ends = ends_of(two);
  EXPECT_EQ(ends[0].after, (Vec2{200, 9}));
  EXPECT_EQ(ends[1].before, (Vec2{0, 0}));
  EXPECT_FALSE(ends[0].before || ends[1].after);
  const std::vector<Road> three = {two[0], two[1], road_of_6_m({{100, 0}, {100, 50}})};
  for (const StripEnds& end : ends_of(three)) EXPECT_FALSE(end.before || end.after);
}

TEST(TrimmedRoads, KnowHowMuchOfThemWentBefore) {
  Road whole = road_of_6_m({{0, 0}, {10, 0}, {20, 0}, {2000, 0}, {2010, 0}});
  whole.points = {{1, map::TrackPointKind::kZebra, 0}, {3, map::TrackPointKind::kStop, 1}};
  const auto parts = trimmed_to(whole, {{2004, -1}, {2006, 1}}, 0);
  ASSERT_EQ(parts.size(), 1u);
  // the segment in the box, one that touches it, and the neighbour whose mitre they end on
  EXPECT_EQ(parts[0].axis, (Polyline{{10, 0}, {20, 0}, {2000, 0}, {2010, 0}}));
  EXPECT_EQ(parts[0].start_along_m, 10);
  EXPECT_EQ(parts[0].points,
            (std::vector<map::TrackPoint>{{0, map::TrackPointKind::kZebra, 0}, {2, map::TrackPointKind::kStop, 1}}));
}

TEST(Pavements, LieBesideTheStripOnTheirSide) {
  EXPECT_TRUE(stroke_pavements(road_of_6_m({{0, 0}, {100, 0}})).empty());
  const std::vector<Ring> left = stroke_pavements(road_of_6_m({{0, 0}, {100, 0}}, 2, 0));
  EXPECT_DOUBLE_EQ(rings_area_m2(left), 800);
  EXPECT_EQ(box_of(left.front()), (Box2{{0, -3}, {100, 5}}));
}

TEST(Pavements, EndBeforeVergesOutsideOfThem) {
  const map::Lane verge{map::LaneKind::kVerge, map::LaneDirection::kBoth, 1.5, 0, true};
  Road edged = road_of_6_m({{0, 0}, {100, 0}}, 2, 2);
  edged.section.lanes.insert(edged.section.lanes.begin(), verge);    // outside the left pavement
  edged.section.lanes.insert(edged.section.lanes.end() - 1, verge);  // between the right one and its kerb
  EXPECT_EQ(box_of(stroke_pavements(edged).front()), (Box2{{0, -6.5}, {100, 5}}));
  Road green = road_of_6_m({{0, 0}, {100, 0}});
  green.section.lanes.push_back(verge);
  EXPECT_TRUE(stroke_pavements(green).empty());
}

TEST(Pavements, FollowBends) {
  const double length = 100 + std::sqrt(2600.0);
  EXPECT_NEAR(rings_area_m2(stroke_pavements(road_of_6_m({{0, 0}, {100, 0}, {110, 50}}, 2, 2))), 10 * length, 0.2);
}

TEST(DriftingRoads, GoOverLinearlyInTheirCarriageway) {
  Road road = road_of_6_m({{0, 0}, {40, 0}, {100, 0}});
  road.section.axis_offset_m = 1, road.section.axis_drift = 1.0 / 32;
  Box2 box;
  for (const Ring& ring : stroke_carriageway(road))
    for (const Vec2 p : ring) {
      EXPECT_TRUE(std::abs(p.y - (1 + p.x / 32)) < 0.002 || std::abs(p.y - (1 + p.x / 32 - 6)) < 0.002) << p.x;
      box.grow(p);
    }
  EXPECT_NEAR(box.max.y, 1 + 100 / 32.0, 0.002);
  EXPECT_EQ(box.min.y, -5);
  EXPECT_NEAR(rings_area_m2(stroke_carriageway(road)), 600, 0.1);
}

TEST(DriftingRoads, HaveTheirEdgesWhereverTheyAreCut) {
  Road whole = road_of_6_m({{0, 0}, {40, 0}, {100, 0}});
  whole.section.axis_offset_m = 1, whole.section.axis_drift = 1.0 / 32;
  Road part = whole;
  part.axis = {{40, 0}, {100, 0}}, part.start_along_m = 40;
  EXPECT_EQ(stroke_carriageway(part).back(), stroke_carriageway(whole)[1]);
  EXPECT_EQ(max_offset_m(part), max_offset_m(whole));
}

TEST(DriftingRoads, MeetTheNextRoadWithTheOffsetOfTheirEnd) {
  std::vector<Road> roads = {road_of_6_m({{0, 0}, {64, 0}}), road_of_6_m({{64, 0}, {128, 0}})};
  roads[0].section.axis_offset_m = 1, roads[0].section.axis_drift = 1.0 / 32;
  EXPECT_EQ(arm_left_m(roads, {0, 0, 1}), 1);
  EXPECT_EQ(arm_right_m(roads, {0, 1, -1}), 3);
  EXPECT_EQ(arm_left_m(roads, {0, 1, -1}), 3);
  // equal edges there: no change of width, so no junction
  EXPECT_TRUE(find_nodes(roads).empty());
}

// The axis lies 1 m from the left edge, on the outside of a bend of more than a right angle.
TEST(RoadStrip, SharpBendsAreRoundWithTheHalfOutsideOfThem) {
  Road shifted = road_of_6_m({{0, 0}, {100, 0}, {90, -60}});
  shifted.section.axis_offset_m = 1;
  for (const Ring& ring : stroke_of(shifted)) EXPECT_LE(box_of(ring).max.x, 101.001);
}

}  // namespace
}  // namespace citykiln::roads

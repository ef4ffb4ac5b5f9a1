#include "compiler/roads/expand.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/geometry/overlay.h"

namespace citykiln::roads {
namespace {

Road road(Polyline axis, double left_m = 0, double right_m = 0) {
  return {{}, std::move(axis), map::SurfaceClass::kResidentialRoad, 6, false, false, left_m, right_m};
}

double area_of(const std::vector<Ring>& rings) {
  std::vector<OwnedSegment> segments;
  for (const Ring& ring : rings) add_ring(segments, ring, 0);
  double area = 0;
  const auto owned = overlay(segments, 1);
  for (const Polygon& polygon : owned[0]) area += area_m2(polygon);
  return area;
}

TEST(RoadStrip, CoversItsAxisAsWideAsItIs) {
  EXPECT_DOUBLE_EQ(area_of(stroke(road({{0, 0}, {100, 0}}))), 600);
  // a right bend to the left: the inner corner counts once, the outer one is filled
  EXPECT_NEAR(area_of(stroke(road({{0, 0}, {100, 0}, {110, 50}}))), 6 * (100 + std::sqrt(2600.0)), 0.2);
}

TEST(RoadStrip, IsMadeOfCounterClockwiseRings) {
  for (const Ring& ring : stroke(road({{0, 0}, {20, 3}, {5, 9}, {40, 9}, {41, 60}})))
    EXPECT_GT(signed_area_m2(ring), 0);
}

TEST(Pavements, LieBesideTheStripOnTheirSide) {
  EXPECT_TRUE(stroke_pavements(road({{0, 0}, {100, 0}})).empty());
  const std::vector<Ring> left = stroke_pavements(road({{0, 0}, {100, 0}}, 2, 0));
  EXPECT_DOUBLE_EQ(area_of(left), 800);
  EXPECT_EQ(box_of(left.front()), (Box2{{0, -3}, {100, 5}}));
}

TEST(Pavements, FollowBends) {
  const double length = 100 + std::sqrt(2600.0);
  EXPECT_NEAR(area_of(stroke_pavements(road({{0, 0}, {100, 0}, {110, 50}}, 2, 2))), 10 * length, 0.2);
}

}  // namespace
}  // namespace citykiln::roads

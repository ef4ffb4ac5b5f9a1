#include "compiler/geometry/segment.h"

#include <gtest/gtest.h>

#include <vector>

namespace citykiln {
namespace {

const std::vector<Vec2> kBent = {{0, 0}, {4, 0}, {4, 3}};

TEST(Segment, IsNearestAtAnEndOrAtTheFootOfThePerpendicular) {
  EXPECT_EQ(nearest_share(Vec2{0, 0}, Vec2{4, 0}, Vec2{1, 7}), 0.25);
  EXPECT_EQ(nearest_share(Vec2{0, 0}, Vec2{4, 0}, Vec2{9, 7}), 1);
  EXPECT_EQ(distance_to_segment(Vec2{0, 0}, Vec2{4, 0}, Vec2{-3, 4}), 5);
}

TEST(Segment, MayBeAPoint) {
  EXPECT_EQ(nearest_share(Vec2{1, 1}, Vec2{1, 1}, Vec2{4, 5}), 0);
  EXPECT_EQ(distance_to_segment(Vec2{1, 1}, Vec2{1, 1}, Vec2{4, 5}), 5);
}

TEST(Segment, ARingIsClosedAndAPolylineIsNot) {
  EXPECT_EQ(distance_to_polyline(kBent, {1, 1}), 1);
  EXPECT_EQ(distance_to_polyline(kBent, {0, 2}), 2);
  EXPECT_EQ(distance_to_ring(kBent, {0, 2}), 1.6);  // 8 / 5
  EXPECT_EQ(distance_to_polyline(std::vector<Vec2>{{0, 0}}, {0, 2}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(distance_to_ring(std::vector<Vec2>{{0, 0}}, {0, 2}), 2);
}

TEST(Segment, CrossesAnotherBetweenTheirEndsOnly) {
  EXPECT_EQ(crossing_shares({0, 0}, {4, 0}, {1, -1}, {1, 3}), std::pair(0.25, 0.25));
  EXPECT_FALSE(crossing_shares({0, 0}, {4, 0}, {1, 1}, {1, 3}));
  EXPECT_FALSE(crossing_shares({0, 0}, {4, 0}, {1, 1}, {3, 1}));
}

}  // namespace
}  // namespace citykiln

#include "compiler/geometry/oriented_rect.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(OrientedRect, HasItsCornersCounterClockwise) {
  const auto corners = corners_of({.at = {1, 2}, .ahead = {0, 1}, .length_m = 4, .width_m = 2});
  EXPECT_EQ(corners, (std::array<Vec2, 4>{Vec2{2, 0}, {2, 4}, {0, 4}, {0, 0}}));
}

TEST(OrientedRect, OverlapsByMoreThanABorder) {
  const OrientedRect a{.at = {0, 0}, .ahead = {1, 0}, .length_m = 4, .width_m = 2};
  OrientedRect b = a;
  b.at.x = 3.9;
  EXPECT_TRUE(overlap(a, b, 0));
  EXPECT_FALSE(overlap(a, b, 0.125));
  b.at.x = 4.1;
  EXPECT_FALSE(overlap(a, b, 0));
  EXPECT_TRUE(overlap(a, b, -0.125)) << "nearer than the distance";
}

TEST(OrientedRect, OverlapsNotBesideACornerOfATurnedOne) {
  const OrientedRect a{.at = {0, 0}, .ahead = {1, 0}, .length_m = 2, .width_m = 2};
  const OrientedRect b{.at = {1.9, 1.9}, .ahead = unit(Vec2{1, 1}), .length_m = 2, .width_m = 2};
  EXPECT_FALSE(overlap(a, b, 0)) << "their boxes overlap";
  EXPECT_TRUE(overlaps_any(index_rects({b, a}), a, 0));
  EXPECT_FALSE(overlaps_any(index_rects({b}), a, 0));
  EXPECT_FALSE(overlaps_any({}, a, 0));
}

}  // namespace
}  // namespace citykiln

#include "compiler/geometry/polygons/centroid.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(Centroid, OfARectangleIsItsMiddle) { EXPECT_EQ(centroid({{{2, 3}, {6, 3}, {6, 5}, {2, 5}}, {}}), (Vec2{4, 4})); }

TEST(Centroid, AHolePushesItAway) {
  const Polygon polygon{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{2, 1}, {2, 3}, {4, 3}, {4, 1}}}};
  // 16 square metres about (2, 2) without 4 about (3, 2)
  EXPECT_NEAR(centroid(polygon).x, (16 * 2 - 4 * 3) / 12.0, 1e-12);
  EXPECT_NEAR(centroid(polygon).y, 2, 1e-12);
}

TEST(Centroid, WithoutAreaIsTheFirstPoint) { EXPECT_EQ(centroid({{{1, 2}, {5, 2}}, {}}), (Vec2{1, 2})); }

}  // namespace
}  // namespace citykiln

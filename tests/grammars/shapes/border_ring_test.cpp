#include "grammars/shapes/border_ring.h"

#include <gtest/gtest.h>

namespace citykiln::grammars {
namespace {

using Vertices = std::vector<std::uint32_t>;

TEST(BorderRing, GoesAroundWithTheTrianglesToItsLeft) {
  EXPECT_EQ(border_ring(std::vector<Triangle>{{7, 3, 5}}), (Vertices{7, 3, 5}));
  EXPECT_EQ(border_ring(std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}), (Vertices{0, 1, 2, 3}));
  // a hexagon about its middle, and one triangle beside it
  EXPECT_EQ(
      border_ring(std::vector<Triangle>{{6, 0, 1}, {6, 1, 2}, {6, 2, 3}, {6, 3, 4}, {6, 4, 5}, {6, 5, 0}, {1, 0, 9}}),
      (Vertices{1, 2, 3, 4, 5, 0, 9}));
}

TEST(BorderRing, IsNoneWhereThereAreMoreOrNone) {
  const std::vector<Triangle> apart = {{0, 1, 2}, {3, 4, 5}}, touching = {{0, 1, 2}, {0, 3, 4}};
  const std::vector<Triangle> with_hole = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}};
  const std::vector<Triangle> closed = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, twice = {{0, 1, 2}, {0, 1, 3}};
  for (const auto& triangles : {apart, touching, with_hole, closed, twice, {}}) EXPECT_FALSE(border_ring(triangles));
}

}  // namespace
}  // namespace citykiln::grammars

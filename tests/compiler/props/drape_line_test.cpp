#include "compiler/props/drape_line.h"

#include <gtest/gtest.h>

namespace citykiln::props {
namespace {

// A square of 10 m whose last point is the first one.
const std::vector<Vec3> kSquareLine = {{0, 0, 1}, {10, 0, 2}, {10, 10, 3}, {0, 10, 2}, {0, 0, 1}};

TEST(MitredSide, ReachesTheCornerOfBothSides) {
  const Vec2 side = mitred_side(kSquareLine, 1, false);
  EXPECT_NEAR(side.x, -1, 1e-12);
  EXPECT_NEAR(side.y, 1, 1e-12);
}

TEST(MitredSide, IsSquareToTheEndsOfAnOpenLineAlone) {
  EXPECT_EQ(mitred_side(kSquareLine, 0, false), (Vec2{0, 1}));
  EXPECT_EQ(mitred_side(kSquareLine, 4, false), (Vec2{1, 0}));
  EXPECT_EQ(mitred_side(kSquareLine, 0, true), mitred_side(kSquareLine, 4, true));
  EXPECT_NEAR(length(mitred_side(kSquareLine, 0, true) - Vec2{1, 1}), 0, 1e-12);
}

TEST(MitredSide, IsAtMostTwiceAsLongInSharpBends) {
  EXPECT_NEAR(length(mitred_side({{0, 0, 0}, {10, 0, 0}, {0, 1, 0}}, 1, false)), 2, 1e-12);
  EXPECT_EQ(mitred_side({{0, 0, 0}, {10, 0, 0}, {0, 0, 0}}, 1, false), (Vec2{0, 1})) << "turns back";
}

}  // namespace
}  // namespace citykiln::props

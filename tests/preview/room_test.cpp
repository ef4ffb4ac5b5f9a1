#include "preview/surface/room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

// A pane of 1.2 by 1.5 m that faces south, whose corner is on the grid of decimetres.
const Vec3 kCorners[4] = {{2.5, 0, 4}, {3.7, 0, 4}, {3.7, 0, 5.5}, {2.5, 0, 5.5}};

TEST(Room, APaneIsFoundFromEitherOfItsTriangles) {
  const auto low = pane_of({kCorners[0], kCorners[1], kCorners[2]}),
             high = pane_of({kCorners[2], kCorners[3], kCorners[0]});
  ASSERT_TRUE(low && high);
  for (const Pane& pane : {*low, *high}) {
    EXPECT_NEAR(pane.width_m, 1.2, 1e-12);
    EXPECT_NEAR(pane.height_m, 1.5, 1e-12);
    EXPECT_NEAR(length(pane.corner - kCorners[0]), 0, 1e-12);
    EXPECT_NEAR(dot(pane.inward, Vec3{0, 1, 0}), 1, 1e-12);
  }
  EXPECT_FALSE(pane_of({Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(pane_of({Vec3{0, 0, 0}, {4, 0, 0}, {2, 0, 0.4}}));
  EXPECT_FALSE(pane_of({Vec3{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
}

TEST(Room, IsTheSameBehindBothTriangles) {
  const auto low = pane_of({kCorners[0], kCorners[1], kCorners[2]}),
             high = pane_of({kCorners[2], kCorners[3], kCorners[0]});
  ASSERT_TRUE(low && high);
  const PixelSamples pixel(1, 2, 3, {4, 4});
  for (std::uint32_t i = 0; i < 16; ++i) {
    PathDraw one(pixel, i), other(pixel, i);
    const Vec3 at{2.9, 0, 4.7}, direction = unit(Vec3{0.3, 1, -0.2});
    const RoomWay a = way_through_room(*low, {100, 200, 3}, at, direction, one),
                  b = way_through_room(*high, {100, 200, 3}, at, direction, other);
    EXPECT_NEAR(length(a.seen_at - b.seen_at), 0, 1e-9);
    EXPECT_GT(a.seen_at.y, 0);
  }
}

// Light of 1 through the pane, from everywhere: the wall that is seen gets the share of its hemisphere that the pane
// takes, and some more from the other walls.
TEST(Room, GetsTheLightOfItsPane) {
  const auto pane = pane_of({kCorners[0], kCorners[1], kCorners[2]});
  ASSERT_TRUE(pane);
  constexpr int kSamples = 16384;
  const PixelSamples pixel(5, 0, 0, grid_of(1, 1, kSamples));
  double sum = 0, deep_m = 0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    PathDraw draw(pixel, i);
    const RoomWay way = way_through_room(*pane, {}, {3.1, 0, 4.75}, {0, 1, 0}, draw);
    sum += way.weight[1] / kSamples, deep_m = way.seen_at.y;
    if (way.weight[1] > 0) {
      EXPECT_LT(way.direction.y, 0);
    }
  }
  ASSERT_GT(deep_m, 2.9);
  const double direct = 0.5 * 1.2 * 1.5 / (std::numbers::pi * deep_m * deep_m);
  EXPECT_GT(sum, direct);
  EXPECT_LT(sum, 3 * direct);
}

}  // namespace
}  // namespace citykiln::preview

#include "compiler/geometry/polygons/clip_polyline.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

constexpr double kStep_m = 0x1p-7;
constexpr Box2 kBox{{0, 0}, {128, 256}};

using Parts = std::vector<Polyline>;

TEST(ClipPolyline, ALineInsideStaysUnchanged) {
  const Polyline closed = {{1, 1}, {5, 1}, {5, 5}, {1, 1}};
  EXPECT_EQ(clipped_to(closed, kBox, kStep_m), Parts{closed});
  EXPECT_EQ(clipped_to({{0, 0}, {128, 256}}, kBox, kStep_m), (Parts{{{0, 0}, {128, 256}}}));
}

TEST(ClipPolyline, ALineOutsideHasNoParts) {
  EXPECT_TRUE(clipped_to({{-5, 300}, {-5, -300}, {500, -300}}, kBox, kStep_m).empty());
  // its box meets the box
  EXPECT_TRUE(clipped_to({{-100, 10}, {10, -100}}, kBox, kStep_m).empty());
  EXPECT_TRUE(clipped_to({}, kBox, kStep_m).empty());
}

TEST(ClipPolyline, IsCutExactlyAtTheSides) {
  EXPECT_EQ(clipped_to({{-10, 10}, {10, 10}, {10, 300}, {20, 300}, {20, 200}, {200, 200}}, kBox, kStep_m),
            (Parts{{{0, 10}, {10, 10}, {10, 256}}, {{20, 256}, {20, 200}, {128, 200}}}));
}

TEST(ClipPolyline, OneSegmentMayCrossTwoSides) {
  EXPECT_EQ(clipped_to({{-64, 64}, {192, 64}}, kBox, kStep_m), (Parts{{{0, 64}, {128, 64}}}));
}

TEST(ClipPolyline, AClosedLineIsCutOnlyWhereItLeaves) {
  const Polyline ring = {{10, 10}, {10, 50}, {200, 50}, {200, 20}, {20, 20}, {10, 10}};
  EXPECT_EQ(clipped_to(ring, kBox, kStep_m), (Parts{{{128, 20}, {20, 20}, {10, 10}, {10, 50}, {128, 50}}}));
}

TEST(ClipPolyline, NewPointsAreOnTheGridAndInTheBox) {
  for (int i = 1; i < 200; ++i) {
    const Polyline line = {{-3.0 * i, 7 + i * 0.25}, {150 + i * 0.5, 90 - i * 0.125}};
    for (const Polyline& part : clipped_to(line, kBox, kStep_m))
      for (const Vec2 p : part) {
        EXPECT_TRUE(kBox.contains(p));
        EXPECT_EQ(std::floor(p.x / kStep_m) * kStep_m, p.x);
        EXPECT_EQ(std::floor(p.y / kStep_m) * kStep_m, p.y);
        EXPECT_TRUE(p.x == 0 || p.x == 128 || p.y == 0 || p.y == 256);
      }
    EXPECT_FALSE(clipped_to(line, kBox, kStep_m).empty());
  }
}

}  // namespace
}  // namespace citykiln

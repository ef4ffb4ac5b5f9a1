#include "compiler/geometry/polygons/clip_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/geometry/ring_crossing.h"

namespace citykiln {
namespace {

double total_m2(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += area_m2(polygon);
  return sum;
}

TEST(ClipPolygon, ABowTieBecomesTheLoopThatRunsCounterClockwise) {
  const std::vector<Polygon> parts = united(std::vector<Ring>{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(total_m2(parts), 4);
  EXPECT_TRUE(is_simple(parts[0].outer));
}

TEST(ClipPolygon, HolesStayHoles) {
  const std::vector<Ring> rings = {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{2, 2}, {2, 4}, {4, 4}, {4, 2}}};
  const std::vector<Polygon> parts = united(rings);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].holes.size(), 1u);
  EXPECT_EQ(total_m2(parts), 77);
}

TEST(ClipPolygon, OutsideOfTheBoxNothingIsLeft) {
  const std::vector<Ring> rings = {{{-50, -10}, {300, -10}, {300, 20}, {-50, 20}}, {{0, 500}, {9, 500}, {9, 509}}};
  const std::vector<Polygon> parts = united_in(rings, {{0, 0}, {256, 128}});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(total_m2(parts), 256 * 20);
  EXPECT_TRUE(std::ranges::count(parts[0].outer, Vec2{128, 0}) == 1) << "a vertex at each multiple of 128 m";
  EXPECT_TRUE(united_in(std::vector<Ring>{rings[1]}, {{0, 0}, {256, 128}}).empty());
}

// Rings through random points cross themselves many times; the boxes of tiles divide what they cover.
TEST(ClipPolygon, TilesShareBordersAndTogetherAreTheWhole) {
  std::mt19937 chance(7);
  const auto coordinate = [&] { return static_cast<double>(chance() % 65536) / 128; };
  int with_area = 0;
  for (int round = 0; round < 40; ++round) {
    Ring ring;
    for (int i = 0; i < 12; ++i) ring.push_back({coordinate(), coordinate()});
    std::vector<Ring> pieces;
    double sum_m2 = 0;
    for (const double x : {0.0, 256.0})
      for (const double y : {0.0, 256.0})
        for (const Polygon& polygon : united_in(std::vector<Ring>{ring}, {{x, y}, {x + 256, y + 256}})) {
          sum_m2 += area_m2(polygon);
          std::ranges::move(copied_rings(polygon), std::back_inserter(pieces));
        }
    const std::vector<Polygon> whole = united(std::vector<Ring>{ring}), joined = united(pieces);
    // some rings run clockwise about all that they enclose
    if (!whole.empty()) ++with_area;
    // each vertex may move by 2^-10 m, along edges of at most 725 m
    EXPECT_NEAR(total_m2(joined), total_m2(whole), 12 * 725 * 0x1p-9);
    EXPECT_NEAR(total_m2(joined), sum_m2, 0x1p-20);
    for (const Polygon& polygon : joined)
      for (const Ring& simple : copied_rings(polygon)) EXPECT_TRUE(is_simple(simple));
  }
  EXPECT_GT(with_area, 30);
}

}  // namespace
}  // namespace citykiln

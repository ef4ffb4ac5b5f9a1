#include "compiler/geometry/polygons/offset_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compiler/geometry/ring_crossing.h"

namespace citykiln {
namespace {

std::size_t edges_of(const Polygon& polygon) {
  std::size_t edges = polygon.outer.size();
  for (const Ring& hole : polygon.holes) edges += hole.size();
  return edges;
}

double total_area_m2(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += area_m2(polygon);
  return sum;
}

double bands_of(const OffsetPolygon& offset) {
  double sum = 0;
  for (const auto& bands : offset.bands) sum += total_area_m2(bands);
  return sum;
}

std::vector<double> all(const Polygon& polygon, double depth_m) {
  return std::vector<double>(edges_of(polygon), depth_m);
}

const Polygon kRectangle = {{{0, 0}, {10, 0}, {10, 8}, {0, 8}}, {}};
const Polygon kSmallCourtyard = {{{0, 0}, {20, 0}, {20, 16}, {0, 16}}, {{{6, 5}, {6, 11}, {14, 11}, {14, 5}}}};

TEST(Inset, IsMitred) {
  const OffsetPolygon offset = inset(kRectangle, all(kRectangle, 1));
  ASSERT_EQ(offset.moved.size(), 1u);
  EXPECT_EQ(offset.moved[0].outer, (Ring{{1, 1}, {9, 1}, {9, 7}, {1, 7}}));
  for (const auto& bands : offset.bands) EXPECT_EQ(bands.size(), 1u);
}

TEST(Inset, EachEdgeHasItsOwnDepth) {
  const OffsetPolygon offset = inset(kRectangle, std::vector<double>{2, 0, 1, 0});
  EXPECT_NEAR(total_area_m2(offset.moved), 10 * 5, 1e-9);
  EXPECT_NEAR(total_area_m2(offset.bands[0]), 20, 1e-9);
  EXPECT_TRUE(offset.bands[1].empty());
}

TEST(Inset, LeavesNothingWhereItIsDeeperThanThePolygon) {
  const OffsetPolygon offset = inset(kRectangle, all(kRectangle, 5));
  EXPECT_NEAR(total_area_m2(offset.moved), 0, 1e-3);
  EXPECT_NEAR(bands_of(offset), 80, 1e-3);
}

TEST(Inset, SplitsWhereItPassesANeck) {
  const Polygon dumbbell = {
      {{0, 0}, {6, 0}, {6, 2}, {10, 2}, {10, 0}, {16, 0}, {16, 5}, {10, 5}, {10, 3}, {6, 3}, {6, 5}, {0, 5}}, {}};
  const OffsetPolygon offset = inset(dumbbell, all(dumbbell, 0.75));
  EXPECT_EQ(offset.moved.size(), 2u);
  EXPECT_NEAR(total_area_m2(offset.moved) + bands_of(offset), area_m2(dumbbell), 0.01);
}

TEST(Inset, RingsThatPassEachOtherLeaveNothing) {
  const OffsetPolygon offset = inset(kSmallCourtyard, all(kSmallCourtyard, 3.5));
  EXPECT_NEAR(total_area_m2(offset.moved), 0, 0.01);
  EXPECT_NEAR(bands_of(offset), area_m2(kSmallCourtyard), 0.01);
}

TEST(Outset, IsThePolygonAndItsBands) {
  const OffsetPolygon offset = outset(kSmallCourtyard, all(kSmallCourtyard, 1));
  EXPECT_NEAR(total_area_m2(offset.moved), 22 * 18 - 6 * 4, 1e-9);
  EXPECT_NEAR(bands_of(offset), total_area_m2(offset.moved) - area_m2(kSmallCourtyard), 1e-9);
}

TEST(Outset, JoinsWhatGrowsTogether) {
  const Polygon u = {{{0, 0}, {9, 0}, {9, 8}, {5, 8}, {5, 3}, {4, 3}, {4, 8}, {0, 8}}, {}};
  const OffsetPolygon offset = outset(u, all(u, 1));
  EXPECT_NEAR(total_area_m2(offset.moved), 11 * 10, 0.01);
}

TEST(Outset, SharpCornersAreBevelled) {
  const Polygon needle = {{{0, 0}, {100, 0}, {0, 2}}, {}};
  const OffsetPolygon offset = outset(needle, all(needle, 1));
  ASSERT_EQ(offset.moved.size(), 1u);
  EXPECT_GT(offset.moved[0].outer.size(), 3u);
  for (const Vec2 p : offset.moved[0].outer) EXPECT_LT(p.x, 100 + kMitreLimit);
}

struct AnyOffset : testing::Test {
  std::mt19937 chance{5};
  double between(double low, double high) { return low + (high - low) * static_cast<double>(chance()) / 4294967296.0; }

  Polygon star() {
    Polygon polygon;
    const auto ring = [&](double low, double high, bool clockwise) {
      Ring points;
      const int n = 3 + static_cast<int>(chance() % 10);
      for (int i = 0; i < n; ++i) {
        const double turn = 6.283185307 * (clockwise ? n - i : i) / n, r = between(low, high);
        points.push_back({r * std::cos(turn), r * std::sin(turn)});
      }
      return points;
    };
    polygon.outer = ring(4, 10, false);
    if (chance() % 2) polygon.holes.push_back(ring(0.5, 1.5, true));
    return polygon;
  }
};

TEST_F(AnyOffset, InwardCoversThePolygonAndNoMore) {
  for (int round = 0; round < 3000; ++round) {
    const Polygon polygon = star();
    std::vector<double> depths = all(polygon, between(0.01, 3));
    for (double& d : depths)
      if (chance() % 4 == 0) d = 0;
    const OffsetPolygon offset = inset(polygon, depths);
    ASSERT_EQ(offset.bands.size(), depths.size());
    ASSERT_NEAR(total_area_m2(offset.moved) + bands_of(offset), area_m2(polygon), 0.02) << "round " << round;
    for (const Polygon& moved : offset.moved) ASSERT_TRUE(is_simple(moved.outer)) << "round " << round;
  }
}

TEST_F(AnyOffset, OutwardIsLargerByItsBands) {
  for (int round = 0; round < 3000; ++round) {
    const Polygon polygon = star();
    const OffsetPolygon offset = outset(polygon, all(polygon, between(0.01, 3)));
    ASSERT_NEAR(total_area_m2(offset.moved) - bands_of(offset), area_m2(polygon), 0.02) << "round " << round;
  }
}

}  // namespace
}  // namespace citykiln

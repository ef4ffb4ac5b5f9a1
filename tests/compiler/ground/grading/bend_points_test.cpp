#include "compiler/ground/grading/bend_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/ground/generate.h"

namespace citykiln::ground {
namespace {

using map::Heightfield;
using map::LandCoverClass;

constexpr Box2 kBendCell{{0, 0}, {128, 128}};

// A slope of one in eight, some metres over a lake whose shore runs across the cell.
struct SlopingShore {
  std::vector<LandCoverPolygon> surfaces;
  GradedTerrain graded;
};

Heightfield slope() {
  Heightfield field{{-64, -64}, {64, 64}, 5, 5, {}, 0};
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 5; ++column)
      field.heights.push_back(static_cast<std::int32_t>((16 + row * 8) / map::kHeightQuantum_m));
  return field;
}

SlopingShore sloping_shore() {
  LandCoverPolygon lake{
      {{OsmType::kWay, 1}, 0}, LandCoverClass::kLake, 9000, {{{-60, -60}, {190, -60}, {190, 20}, {-60, 40}}}};
  lake.level_m = 10;
  LandCoverPolygon garden{
      {{OsmType::kWay, 2}, 0}, LandCoverClass::kGarden, 2000, {{{20, 10}, {100, 10}, {100, 70}, {20, 70}}}};
  const std::vector<LandCoverPolygon> surfaces = {lake, garden};
  return {surfaces, grade_terrain(slope(), {{}, {}, surfaces, kBendCell.widened(kGrading_m)})};
}

Vec2 place(const RandomSequence& draw, std::uint32_t i) {
  return {draw.between(0, 128, 2 * i), draw.between(0, 128, 2 * i + 1)};
}

TEST(BendPoints, AreTheSameWhicheverWayALineRuns) {
  const SlopingShore shore = sloping_shore();
  const RandomSequence draw(1, StableId{1}, "ends");
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < 200; i += 2) {
    const Vec2 a = place(draw, i), b = place(draw, i + 1);
    GradedHeights one(shore.graded), other(shore.graded);
    auto there = bend_points_along(one, a, b, kBendCell);
    const auto back = bend_points_along(other, b, a, kBendCell);
    std::ranges::reverse(there);
    EXPECT_EQ(there, back);
    count += there.size();
  }
  EXPECT_GT(count, 200u);
}

TEST(BendPoints, AreNoneWithoutGradingHoweverTheTerrainBends) {
  Heightfield rough = slope();
  for (std::size_t i = 0; i < rough.heights.size(); ++i) rough.heights[i] += static_cast<std::int32_t>(i % 3) * 640;
  const GradedTerrain graded(std::move(rough));
  GradedHeights heights(graded);
  EXPECT_TRUE(bend_points_along(heights, {0, 0}, {127, 100}, kBendCell).empty());
}

TEST(BendsOnBorder, BothCellsHaveThem) {
  const SlopingShore shore = sloping_shore();
  const auto on_line = [](std::vector<GridPoint> points, std::int64_t x) {
    std::erase_if(points, [&](GridPoint p) { return p.x != x; });
    return points;
  };
  const std::int64_t x = grid_point(kBendCell.max).x;
  GradedHeights in_west(shore.graded), in_east(shore.graded);
  const auto west = on_line(bend_points_on_border(in_west, kBendCell), x);
  EXPECT_FALSE(west.empty());
  EXPECT_EQ(west, on_line(bend_points_on_border(in_east, {{128, 0}, {256, 128}}), x));
}

// This ground has no steps, so the reference follows it everywhere, not only at its samples.
TEST(ReferenceOfCell, FollowsTheGradedTerrain) {
  const SlopingShore shore = sloping_shore();
  const Reference reference = reference_of_cell(shore.surfaces, shore.graded, kBendCell);
  const RandomSequence draw(2, StableId{2}, "places");
  double largest_m = 0, sum_m = 0;
  constexpr std::uint32_t kPlaces = 20'000;
  for (std::uint32_t i = 0; i < kPlaces; ++i) {
    const Vec2 p = place(draw, i);
    const bool is_under_water = winding_number(shore.surfaces[0].rings[0], p) != 0;
    if (is_under_water) continue;
    const double off_m = std::abs(land_m(shore.graded, p) - height_m_at(reference, p, HeightLayer::kLand));
    largest_m = std::max(largest_m, off_m), sum_m += off_m;
  }
  EXPECT_LT(largest_m, 8 * kReferenceError_m);
  EXPECT_LT(sum_m / kPlaces, kReferenceError_m / 4);
}

}  // namespace
}  // namespace citykiln::ground

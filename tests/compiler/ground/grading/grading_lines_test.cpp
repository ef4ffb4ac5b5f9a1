#include "compiler/ground/grading/grading_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace citykiln::ground {
namespace {

roads::Road street(double x, double z_m) {
  roads::Road road;
  road.id = {{OsmType::kWay, static_cast<std::int64_t>(x) + 1}, 0};
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 8}}, 4};
  road.axis = {{x, -32}, {x, 160}};
  road.profile = {{0, z_m, 0}, {192, z_m, 0}};
  return road;
}

// Counts lines along streets at this x.
long lines_along(const std::vector<roads::Road>& roads, double x) {
  map::Heightfield flat{{-256, -256}, {64, 64}, 9, 9, std::vector<std::int32_t>(81), 0};
  const Box2 cell{{0, 0}, {128, 128}};
  const GradedTerrain graded = grade_terrain(std::move(flat), {roads, {}, {}, cell.widened(kGrading_m), false});
  GradedHeights heights(graded);
  return std::ranges::count_if(grading_lines(heights, cell), [&](const auto& line) {
    return plane_point(line.first).x == x && plane_point(line.second).x == x;
  });
}

TEST(GradingLines, HaveTheTopAndTheFootOfWallsBetweenStreets) {
  for (const double x : {44 + kWallTop_m, 44 + kWallFoot_m}) {
    EXPECT_GT(lines_along({street(40, 4), street(48.25, 0)}, x), 0) << x;
    EXPECT_EQ(lines_along({street(40, 0.3125), street(48.25, 0)}, x), 0) << x;
  }
}

TEST(GradingLines, HaveTheAxisOfARoadWhereItTwists) {
  roads::Road road = street(40, 1);
  EXPECT_EQ(lines_along({road}, 40), 0);
  road.profile.back().tilt = 0.25;
  EXPECT_GT(lines_along({road}, 40), 0);
}

// Counts lines that cross x and extend at most this far to both sides.
long lines_across(const std::vector<roads::Road>& roads, double x, double most_m) {
  map::Heightfield flat{{-256, -256}, {64, 64}, 9, 9, std::vector<std::int32_t>(81), 0};
  const Box2 cell{{0, 0}, {128, 128}};
  const GradedTerrain graded = grade_terrain(std::move(flat), {roads, {}, {}, cell.widened(kGrading_m), false});
  GradedHeights heights(graded);
  return std::ranges::count_if(grading_lines(heights, cell), [&](const auto& line) {
    const double a = plane_point(line.first).x - x, b = plane_point(line.second).x - x;
    return a * b < 0 && std::max(std::abs(a), std::abs(b)) <= most_m;
  });
}

// a path that meets a street of another height is blended with the street before it gets there
TEST(GradingLines, GoAcrossNarrowPathsWhereTheirHeightsAreMixed) {
  roads::Road path = street(40, 0);
  path.section = {{{map::LaneKind::kFoot, map::LaneDirection::kBoth, 1}}, 0.5};
  const long alone = lines_across({path}, 40, 1);
  roads::Road crossing = street(0, 0.5);
  crossing.axis = {{-32, 64}, {160, 64}};
  EXPECT_GE(lines_across({path, crossing}, 40, 1), alone + 2);
}

// Where lines cross the plane's y axis.
std::set<double> crossings_of_axis(const map::Heightfield& terrain, const Box2& cell) {
  const std::vector<roads::Road> roads = {street(40, 1)};
  map::Heightfield copy = terrain;
  const GradedTerrain graded = grade_terrain(std::move(copy), {roads, {}, {}, cell.widened(kGrading_m), false});
  std::set<double> crossings;
  GradedHeights known(graded);
  for (const auto& line : grading_lines(known, cell)) {
    const Vec2 a = plane_point(line.first), b = plane_point(line.second);
    if (a.x < 0 && b.x > 0) crossings.insert(a.y - a.x * (b.y - a.y) / (b.x - a.x));
  }
  return crossings;
}

// a hill that ends at every distance from the common border, so that the eastern cell becomes level
TEST(GradingLines, CrossACommonBorderInBothCells) {
  const Box2 west{{-128, 0}, {0, 128}}, east{{0, 0}, {128, 128}};
  for (int column = 4; column < 20; ++column) {
    map::Heightfield terrain{{-260, -256}, {24, 40}, 24, 14, std::vector<std::int32_t>(24 * 14), 0};
    terrain.heights[static_cast<std::size_t>(8 * 24 + column)] = 640;
    const auto crossings = crossings_of_axis(terrain, west);
    EXPECT_EQ(crossings, crossings_of_axis(terrain, east)) << column;
    EXPECT_EQ(crossings.empty(), terrain.vertex(column - 1, 0).x >= 0 || terrain.vertex(column + 1, 0).x <= 0)
        << column;
  }
}

}  // namespace
}  // namespace citykiln::ground

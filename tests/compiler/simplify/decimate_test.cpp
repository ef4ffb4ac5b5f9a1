#include "compiler/simplify/decimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/compiler/simplify/samples.h"

namespace citykiln::simplify {
namespace {

constexpr std::uint32_t kSide = 40;
constexpr double kStep_m = 16;

bool is_on_rim(std::uint32_t column, std::uint32_t row) {
  return column == 0 || row == 0 || column == kSide || row == kSide;
}

/// Hills over a square; labels are patches of 8 × 8 cells. The border is locked.
LabelledMesh terrain(std::uint64_t seed, double height_m, std::uint32_t labels) {
  LabelledMesh mesh;
  const auto hill = [&](double x, double y, std::uint64_t k) {
    const double dx = x - noise(seed + k) * 640, dy = y - noise(seed + k + 1) * 640;
    return height_m / (1 + (dx * dx + dy * dy) / 4000);
  };
  for (std::uint32_t row = 0; row <= kSide; ++row)
    for (std::uint32_t column = 0; column <= kSide; ++column) {
      const double x = column * kStep_m, y = row * kStep_m;
      double z = noise(seed * 7919 + row * 64 + column) * height_m / 20;
      for (std::uint64_t k = 0; k < 20; k += 2) z += hill(x, y, k);
      mesh.positions.push_back({x, y, z});
      mesh.is_locked.push_back(is_on_rim(column, row));
    }
  for (std::uint32_t row = 0; row < kSide; ++row)
    for (std::uint32_t column = 0; column < kSide; ++column) {
      const std::uint32_t a = row * (kSide + 1) + column, b = a + 1, c = b + kSide + 1, d = a + kSide + 1;
      mesh.triangles.push_back({a, b, c}), mesh.triangles.push_back({a, c, d});
      const auto label = static_cast<std::uint32_t>(noise(seed + (row / 8) * 8 + column / 8) * labels);
      mesh.labels.insert(mesh.labels.end(), 2, label);
    }
  return mesh;
}

std::vector<Corners> corners_with(const LabelledMesh& source, std::span<const Triangle> triangles,
                                  std::span<const std::uint32_t> labels, std::uint32_t label) {
  std::vector<Corners> all;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& p = source.positions;
    if (labels[t] == label) all.push_back({p[triangles[t][0]], p[triangles[t][1]], p[triangles[t][2]]});
  }
  return all;
}

double plan_area_m2(const LabelledMesh& source, std::span<const Triangle> triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles)
    area += twice_area(in_plan(source.positions[a]), in_plan(source.positions[b]), in_plan(source.positions[c])) / 2;
  return area;
}

TEST(Decimate, StatesNoLessThanTheDistanceOfAnySampleOfALabelBothWays) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const LabelledMesh source = terrain(seed, 60, 3);
    const DecimatedMesh made = decimated(source, 5);
    EXPECT_LE(made.error_m, 5);
    EXPECT_LT(made.triangles.size(), source.triangles.size() / 3);
    for (const std::uint32_t label : std::set(source.labels.begin(), source.labels.end())) {
      const auto before = corners_with(source, source.triangles, source.labels, label);
      const auto after = corners_with(source, made.triangles, made.labels, label);
      EXPECT_GE(made.error_m, sampled_distance_m(before, after, 4));
      EXPECT_GE(made.error_m, sampled_distance_m(after, before, 16));
    }
  }
}

TEST(Decimate, KeepsLockedBordersAndCoversThePlan) {
  const LabelledMesh source = terrain(5, 60, 3);
  const DecimatedMesh made = decimated(source, 20);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& [a, b, c] : made.triangles) edges.insert({{a, b}, {b, c}, {c, a}});
  for (std::uint32_t i = 0; i < kSide; ++i) {
    EXPECT_TRUE(edges.contains({i, i + 1}));
    EXPECT_TRUE(edges.contains({(i + 1) * (kSide + 1), i * (kSide + 1)}));
  }
  // every inner edge has a triangle on either side
  for (const auto& [a, b] : edges) {
    const bool is_rim = source.is_locked[a] && source.is_locked[b];
    EXPECT_TRUE(is_rim || edges.contains({b, a}));
  }
  EXPECT_NEAR(plan_area_m2(source, made.triangles), 640.0 * 640, 1e-6);
}

TEST(Decimate, LeavesLittleOfAPlane) {
  LabelledMesh flat = terrain(1, 0, 1);
  std::fill(flat.is_locked.begin(), flat.is_locked.end(), false);
  const DecimatedMesh made = decimated(flat, 1);
  EXPECT_LE(made.triangles.size(), 40u);
  EXPECT_NEAR(plan_area_m2(flat, made.triangles), 640.0 * 640, 640 * 4 * 1.0);
}

TEST(Decimate, KeepsALabelOfOneTriangle) {
  LabelledMesh source = terrain(2, 10, 1);
  source.labels[1000] = 7;
  const DecimatedMesh made = decimated(source, 50);
  EXPECT_EQ(std::ranges::count(made.labels, 7u), 1);
}

TEST(Decimate, GivesTheSameEachTime) {
  const LabelledMesh source = terrain(3, 60, 4);
  const DecimatedMesh one = decimated(source, 8), other = decimated(source, 8);
  EXPECT_EQ(one.triangles, other.triangles);
  EXPECT_EQ(one.labels, other.labels);
  EXPECT_EQ(one.error_m, other.error_m);
}

TEST(Decimate, KeepsWhereThreeTrianglesShareAnEdge) {
  LabelledMesh fins;
  fins.positions = {{0, 0, 0}, {10, 0, 0}, {5, 10, 0}, {5, -10, 0}, {5, 0, 10}};
  fins.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  fins.labels = {0, 0, 0};
  const DecimatedMesh made = decimated(fins, 1);
  EXPECT_EQ(made.triangles.size(), 3u);
}

TEST(DecimateTo, LeavesAboutAsManyTrianglesAsAskedFor) {
  const LabelledMesh source = terrain(6, 60, 1);
  EXPECT_NEAR(static_cast<double>(decimated_to(source, 800).triangles.size()), 800, 2);
}

}  // namespace
}  // namespace citykiln::simplify

#include "compiler/props/railing_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compiler/geometry/snap.h"

namespace citykiln::props {
namespace {

ground::GradedTerrain slope_for_railings() {
  map::Heightfield field{{-64, -64}, {16, 16}, 9, 9, {}, 0};
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) field.heights.push_back(640 + i * i * 20);
  return ground::GradedTerrain(std::move(field));
}

Barrier railing_along(Polyline axis) {
  return {{{OsmType::kWay, 3}, 0}, std::move(axis), map::BarrierKind::kRailing, 1.1, 0.0625};
}

const Barrier kBentRailing = railing_along({{-30, -20}, {0, -20}, {5, -10}, {40, 10}});

TEST(RailingMesh, IsClosedAndAsHighAsTheRecipe) {
  const ground::GradedTerrain ground = slope_for_railings();
  const GeneratedProp made = generate(kBentRailing, ground, 0.02);
  ASSERT_EQ(made.meshes.size(), 1u);
  const Mesh& mesh = made.meshes[0].mesh;
  std::map<std::pair<Vec3, Vec3>, int> edges;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = mesh.positions[t[i]], b = mesh.positions[t[(i + 1) % 3]];
      a < b ? ++edges[{a, b}] : --edges[{b, a}];
    }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0);
  for (const Vec3 p : mesh.positions) {
    EXPECT_EQ(p, snapped(p));
    EXPECT_LT(p.z - land_m(ground, in_plan(p)), 1.1 + 0.06);
    EXPECT_GT(p.z - land_m(ground, in_plan(p)), -0.25);
  }
}

TEST(RailingMesh, LeavesOutPostsThenAll) {
  const ground::GradedTerrain ground = slope_for_railings();
  const auto triangles = [&](double tolerance_m) {
    const GeneratedProp made = generate(kBentRailing, ground, tolerance_m);
    EXPECT_LE(made.error_m, std::max(tolerance_m, 1.1));
    return made.meshes.empty() ? 0 : made.meshes[0].mesh.triangles.size();
  };
  EXPECT_LT(triangles(0.5), triangles(0.1));
  EXPECT_GT(triangles(0.5), 0u);
  EXPECT_EQ(triangles(1.1), 0u);
  EXPECT_LE(generate(kBentRailing, ground, 0.5).error_m, 0.5);
}

}  // namespace
}  // namespace citykiln::props

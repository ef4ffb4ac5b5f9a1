#include "compiler/bake/ground/skirt.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::bake {
namespace {

constexpr Box2 kSkirtTile{{0, 0}, {128, 128}};

// Two faces that fill the western half of the tile, and a kerb on its border.
materials::MaterialMesh half_tile() {
  materials::MaterialMesh surface;
  surface.mesh.positions = {{0, 0, 5}, {64, 0, 6}, {64, 128, 7}, {0, 128, 8}, {10, 0, 5}, {12, 0, 5}, {12, 0, 5.125}};
  surface.mesh.normals.assign(7, {0, 0, 1});
  surface.mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  surface.tints.assign(7, materials::kNoTint);
  surface.uvs = {{0, 0}, {1, 0}, {1, 2}, {0, 2}, {0, 0}, {0, 0}, {0, 0}};
  return surface;
}

TEST(Skirt, HangsBelowEveryEdgeInTheBorderAndNoOther) {
  materials::MaterialMesh surface = half_tile();
  add_skirt(surface, kSkirtTile, 0.6);
  // south, west, north
  ASSERT_EQ(surface.mesh.triangles.size(), 3u + 3 * 2);
  EXPECT_EQ(surface.tints.size(), surface.mesh.positions.size());
  EXPECT_EQ(surface.uvs.size(), surface.mesh.positions.size());
  EXPECT_EQ(surface.mesh.normals.size(), surface.mesh.positions.size());
}

TEST(Skirt, LooksOutwards) {
  materials::MaterialMesh surface = half_tile();
  add_skirt(surface, kSkirtTile, 0.6);
  ASSERT_GT(surface.mesh.triangles.size(), 3u);
  for (std::size_t f = 3; f < surface.mesh.triangles.size(); ++f) {
    const Triangle& t = surface.mesh.triangles[f];
    const auto& p = surface.mesh.positions;
    const Vec3 normal = unit(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
    const Vec3 centre = (p[t[0]] + p[t[1]] + p[t[2]]) * (1.0 / 3);
    EXPECT_EQ(normal.z, 0);
    EXPECT_GT(dot(normal, centre - Vec3{64, 64, centre.z}), 0);
  }
}

// A gap between this level and one five times coarser is at most the sum of both tolerances.
TEST(Skirt, IsAsDeepAsTheGapToACoarserNeighbour) {
  for (const double tolerance_m : {0.02, 0.1, 0.5, 2.5}) {
    materials::MaterialMesh surface = half_tile();
    add_skirt(surface, kSkirtTile, kSkirtDepthTolerances * tolerance_m);
    const auto lowest = std::ranges::min_element(surface.mesh.positions, {}, &Vec3::z);
    EXPECT_GE(5 - lowest->z, tolerance_m + 5 * tolerance_m - 0x1p-10);
  }
}

}  // namespace
}  // namespace citykiln::bake

#include "compiler/bake/skirt.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::bake {
namespace {

constexpr Box2 kTile{{0, 0}, {128, 128}};

// Two faces that fill the western half of the tile, and a kerb that stands on its border.
materials::MaterialMesh half_tile() {
  materials::MaterialMesh dressed;
  dressed.mesh.positions = {{0, 0, 5}, {64, 0, 6}, {64, 128, 7}, {0, 128, 8}, {10, 0, 5}, {12, 0, 5}, {12, 0, 5.125}};
  dressed.mesh.normals.assign(7, {0, 0, 1});
  dressed.mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  dressed.tints.assign(7, materials::kNoTint);
  dressed.uvs = {{0, 0}, {1, 0}, {1, 2}, {0, 2}, {0, 0}, {0, 0}, {0, 0}};
  return dressed;
}

TEST(Skirt, HangsBelowEveryEdgeInTheBorderAndNoOther) {
  materials::MaterialMesh dressed = half_tile();
  add_skirt(dressed, kTile, 0.6);
  // south, west, north
  ASSERT_EQ(dressed.mesh.triangles.size(), 3u + 3 * 2);
  EXPECT_EQ(dressed.tints.size(), dressed.mesh.positions.size());
  EXPECT_EQ(dressed.uvs.size(), dressed.mesh.positions.size());
  EXPECT_EQ(dressed.mesh.normals.size(), dressed.mesh.positions.size());
}

TEST(Skirt, LooksOutwards) {
  materials::MaterialMesh dressed = half_tile();
  add_skirt(dressed, kTile, 0.6);
  for (std::size_t f = 3; f < dressed.mesh.triangles.size(); ++f) {
    const Triangle& t = dressed.mesh.triangles[f];
    const auto& p = dressed.mesh.positions;
    const Vec3 normal = unit(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
    const Vec3 centre = (p[t[0]] + p[t[1]] + p[t[2]]) * (1.0 / 3);
    EXPECT_EQ(normal.z, 0);
    EXPECT_GT(dot(normal, centre - Vec3{64, 64, centre.z}), 0);
  }
}

// A gap between this level and one five times coarser is at most the sum of both tolerances.
TEST(Skirt, IsAsDeepAsTheGapToACoarserNeighbour) {
  for (const double tolerance_m : {0.02, 0.1, 0.5, 2.5}) {
    materials::MaterialMesh dressed = half_tile();
    add_skirt(dressed, kTile, kSkirtDepthTolerances * tolerance_m);
    const auto lowest = std::ranges::min_element(dressed.mesh.positions, {}, &Vec3::z);
    EXPECT_GE(5 - lowest->z, tolerance_m + 5 * tolerance_m - 0x1p-10);
  }
}

}  // namespace
}  // namespace citykiln::bake

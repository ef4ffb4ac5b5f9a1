#include "compiler/props/fence_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "compiler/geometry/snap.h"
#include "compiler/materials/texture.h"

namespace citykiln::props {
namespace {

ground::GradedTerrain slope_for_fences() {
  map::Heightfield field{{-64, -64}, {16, 16}, 9, 9, {}, 0};
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) field.heights.push_back(640 + i * i * 20);
  return ground::GradedTerrain(std::move(field));
}

Barrier fence_of_height(double height_m, std::int64_t id = 3) {
  return {
      {{OsmType::kWay, id}, 0}, {{-30, -20}, {0, -20}, {5, -10}, {40, 10}}, map::BarrierKind::kFence, height_m, 0.0625};
}

TEST(FenceMesh, ALowFenceIsASheetOfBarsOnTheGround) {
  const ground::GradedTerrain ground = slope_for_fences();
  const GeneratedProp made = generate(fence_of_height(1), ground, 0.1);
  ASSERT_EQ(made.meshes.size(), 1u);
  const materials::MaterialMesh& sheet = made.meshes[0];
  EXPECT_EQ(sheet.material, materials::Material::kRailing);
  ASSERT_EQ(sheet.uvs.size(), sheet.mesh.positions.size());
  EXPECT_LE(made.error_m, 0.1);
  for (std::size_t i = 0; i < sheet.mesh.positions.size(); i += 2) {
    const Vec3 foot = sheet.mesh.positions[i], top = sheet.mesh.positions[i + 1];
    EXPECT_EQ(in_plan(foot), in_plan(top));
    EXPECT_EQ(foot, snapped(foot));
    EXPECT_LT(foot.z, land_m(ground, in_plan(foot)));
    EXPECT_NEAR(top.z - land_m(ground, in_plan(top)), 1, 0.01);
  }
}

TEST(FenceMesh, TheTextureRunsInMetresAlongTheFence) {
  const GeneratedProp made = generate(fence_of_height(1), slope_for_fences(), 0.1);
  const materials::MaterialMesh& sheet = made.meshes[0];
  for (std::size_t i = 2; i < sheet.uvs.size(); i += 2)
    EXPECT_NEAR(sheet.uvs[i].x - sheet.uvs[i - 2].x,
                distance(in_plan(sheet.mesh.positions[i]), in_plan(sheet.mesh.positions[i - 2])), 0.02);
}

TEST(FenceMesh, HighFencesAreOfBoardsAndCoarseLevelsHaveNoSheets) {
  EXPECT_TRUE(is_sheet(fence_of_height(1), 0.1));
  EXPECT_FALSE(is_sheet(fence_of_height(1), 50));
  EXPECT_EQ(generate(fence_of_height(1.75), slope_for_fences(), 0.1).meshes[0].material, materials::Material::kPalings);
  EXPECT_EQ(generate(fence_of_height(1.75), slope_for_fences(), 0.1).meshes[0].mesh.triangles.size(),
            generate(fence_of_height(1), slope_for_fences(), 0.1).meshes[0].mesh.triangles.size());
}

TEST(FenceMesh, YardsDecideTheKindOfTheirFence) {
  EXPECT_EQ(kind_of_fence(fence_of_height(1.75)), map::FenceKind::kBoards);
  Barrier fence = fence_of_height(2);
  EXPECT_EQ(kind_of_fence(fence), map::FenceKind::kMesh) << "around works";
  EXPECT_EQ(fence_surface(fence).material, materials::Material::kChainLink);
  fence.fence = map::FenceKind::kPickets;
  EXPECT_EQ(fence_surface(fence).material, materials::Material::kPickets);
}

TEST(FenceMesh, NeighboursHavePaintsOfTheirOwn) {
  std::set<materials::Tint> paints;
  for (std::int64_t id = 1; id < 50; ++id) paints.insert(fence_surface(fence_of_height(1, id)).tint);
  EXPECT_GE(paints.size(), 4u);
}

}  // namespace
}  // namespace citykiln::props

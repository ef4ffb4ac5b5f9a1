#include "compiler/bake/merge.h"

#include <gtest/gtest.h>

#include <set>

namespace citykiln::bake {
namespace {

using materials::ColourSource;
using materials::Material;
using materials::MaterialMesh;

/// Two triangles that share an edge: a square of 2 m, flat unless normals are asked for.
MaterialMesh square(Material material, bool is_smooth = true) {
  MaterialMesh surface;
  surface.mesh.positions = {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}};
  if (is_smooth) surface.mesh.normals.assign(4, {0, 0, 1});
  surface.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  surface.material = material;
  return surface;
}

MaterialMesh laid_out(Material material, ColourSource colour_source) {
  MaterialMesh surface = square(material);
  surface.uvs = {{0, 100}, {2, 100}, {2, 102}, {0, 102}};
  surface.colour_source = colour_source;
  return surface;
}

std::vector<Primitive> merged(const std::vector<MaterialMesh>& meshes) {
  PrimitiveMap all;
  for (const MaterialMesh& mesh : meshes) merge(all, {mesh, Layer::kGround}, {}, 0);
  return primitives_of(std::move(all));
}

TEST(Merge, OnePrimitiveAKeySortedByKey) {
  const auto primitives =
      merged({laid_out(Material::kAsphalt, ColourSource::kByMarkingAtlas), square(Material::kBark),
              laid_out(Material::kAsphalt, ColourSource::kByMaterial), square(Material::kAsphalt),
              laid_out(Material::kAsphalt, ColourSource::kByMarkingAtlas), square(Material::kGrass)});
  const std::vector<PrimitiveKey> expected = {{Layer::kGround, Material::kGrass, false, ColourSource::kByMaterial},
                                              {Layer::kGround, Material::kAsphalt, false, ColourSource::kByMaterial},
                                              {Layer::kGround, Material::kAsphalt, true, ColourSource::kByMaterial},
                                              {Layer::kGround, Material::kAsphalt, true, ColourSource::kByMarkingAtlas},
                                              {Layer::kGround, Material::kBark, false, ColourSource::kByMaterial}};
  ASSERT_EQ(primitives.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(key_of(primitives[i]), expected[i]) << i;
  EXPECT_EQ(primitives[3].positions.size(), 8u);
}

TEST(Merge, EachVertexHasTheUvOfItsPosition) {
  const auto primitives = merged({laid_out(Material::kAsphalt, ColourSource::kByMaterial),
                                  laid_out(Material::kAsphalt, ColourSource::kByMaterial)});
  ASSERT_EQ(primitives.size(), 1u);
  ASSERT_EQ(primitives[0].uvs.size(), primitives[0].positions.size());
  for (std::size_t v = 0; v < primitives[0].uvs.size(); ++v) {
    const Float3& at = primitives[0].positions[v];
    EXPECT_EQ(primitives[0].uvs[v], (Float2{at[0], at[1] + 100}));
  }
}

TEST(Merge, EachVertexHasTheTintOfItsPosition) {
  MaterialMesh surface = square(Material::kGrass);
  surface.tints = {{1, 0, 0, 255}, {2, 0, 0, 255}, {3, 0, 0, 255}, {4, 0, 0, 255}};
  const auto primitives = merged({surface});
  for (std::size_t v = 0; v < 4; ++v) {
    const Float3& at = primitives[0].positions[v];
    const int corner = at[1] == 0 ? (at[0] == 0 ? 1 : 2) : (at[0] == 0 ? 4 : 3);
    EXPECT_EQ(primitives[0].colours[v][0], corner);
  }
}

TEST(TexturesShown, AreThoseOfMaterialsWithPlacesOnThem) {
  BakedTile tile;
  tile.primitives = merged({laid_out(Material::kAsphalt, ColourSource::kByMarkingAtlas),
                            laid_out(Material::kGrass, ColourSource::kByMaterial), square(Material::kMeadow),
                            laid_out(Material::kRock, ColourSource::kByMaterial)});
  // two shared meshes with one bark
  for (const char* name : {"pine_0", "spruce_0"})
    tile.instanced.push_back(
        {name, merged({laid_out(Material::kPlatedBark, ColourSource::kByMaterial)}), {}, {}, {}, {}});
  const auto textures = textures_shown(tile, 0.1, materials::TextureCache(1));
  ASSERT_EQ(textures.size(), 3u);
  EXPECT_EQ(textures[0]->material, Material::kGrass);
  EXPECT_EQ(textures[1]->material, Material::kRock);
  EXPECT_EQ(textures[2]->material, Material::kPlatedBark);
  EXPECT_TRUE(textures_shown(tile, 2.5, materials::TextureCache(1)).empty());
}

TEST(Merge, MeshesWithoutUvsGetNone) {
  for (const Primitive& p :
       merged({square(Material::kGrass), laid_out(Material::kAsphalt, ColourSource::kByMarkingAtlas)}))
    EXPECT_EQ(p.uvs.size(), p.colour_source == ColourSource::kByMarkingAtlas ? p.positions.size() : 0);
}

TEST(Merge, SharesVerticesOfOneNormal) {
  EXPECT_EQ(merged({square(Material::kGrass, true)})[0].positions.size(), 4u);
  MaterialMesh folded = square(Material::kGrass, false);
  folded.mesh.positions[3].z = 6;
  EXPECT_EQ(merged({folded})[0].positions.size(), 6u);
}

/// Two squares side by side, as rules make walls of pieces: each with corners of its own.
MaterialMesh side_by_side() {
  MaterialMesh surface = square(Material::kPlaster, false);
  for (const Vec3& p : square(Material::kPlaster).mesh.positions)
    surface.mesh.positions.push_back(p + Vec3{2 + 1e-12, 0, 0});
  surface.mesh.triangles.push_back({4, 5, 6}), surface.mesh.triangles.push_back({4, 6, 7});
  return surface;
}

TEST(Merge, NoTwoVerticesOfAMeshAreAlike) {
  EXPECT_EQ(merged({side_by_side()})[0].positions.size(), 6u);
  EXPECT_EQ(merged({side_by_side()})[0].triangles.size(), 4u);
}

TEST(Merge, VerticesOfOtherUvsOrTintsAreNotAlike) {
  MaterialMesh tinted = side_by_side(), placed = side_by_side();
  for (std::uint8_t v = 0; v < 8; ++v) {
    tinted.tints.push_back({v, 0, 0, 255});
    placed.uvs.push_back({v * 0.5, 0});
  }
  EXPECT_EQ(merged({tinted})[0].positions.size(), 8u);
  EXPECT_EQ(merged({placed})[0].positions.size(), 8u);
}

TEST(Merge, LeavesOutTrianglesThatSinglePrecisionMakesThin) {
  MaterialMesh thin = square(Material::kPlaster, false);
  thin.mesh.positions[0] = {2 - 1e-12, 0, 5};
  EXPECT_EQ(merged({thin})[0].triangles.size(), 1u);
}

TEST(Merge, VerticesOfTrianglesThatAreLeftOutAreLeftOutToo) {
  MaterialMesh thin = square(Material::kPlaster, false);
  const Vec3 corner = thin.mesh.positions[1];
  thin.mesh.positions.push_back(corner + Vec3{1e-12, 0, 0}), thin.mesh.positions.push_back(corner + Vec3{0, 0, 3});
  thin.mesh.triangles.insert(thin.mesh.triangles.begin(), {1, 4, 5});
  const Primitive primitive = merged({thin})[0];
  EXPECT_EQ(primitive.triangles.size(), 2u);
  EXPECT_EQ(primitive.positions.size(), 4u);
  EXPECT_EQ(primitive.normals.size(), 4u);
}

TEST(Merge, APlaceWithTwoUvsIsTwoVertices) {
  MaterialMesh seam = laid_out(Material::kAsphalt, ColourSource::kByMarkingAtlas);
  seam.mesh.positions.push_back(seam.mesh.positions[0]);
  seam.mesh.normals.push_back(seam.mesh.normals[0]);
  seam.uvs.push_back({7, 100});
  seam.mesh.triangles[1][0] = 4;
  const Primitive primitive = merged({seam})[0];
  EXPECT_EQ(primitive.positions.size(), 5u);
  EXPECT_EQ(std::set<Float2>(primitive.uvs.begin(), primitive.uvs.end()).size(), 5u);
}

TEST(Merge, UvsAreRoundedByHalfAMillimetreAtMost) {
  MaterialMesh far = laid_out(Material::kAsphalt, ColourSource::kByMarkingAtlas);
  for (Vec2& uv : far.uvs) uv.y = 16383.123456 + uv.y / 1000;
  ASSERT_FALSE(merged({far}).empty());
  for (const Primitive& p : merged({far}))
    for (std::size_t v = 0; v < p.uvs.size(); ++v)
      EXPECT_NEAR(p.uvs[v][1], 16383.123456 + (p.positions[v][1] + 100.0) / 1000, 0.0005);
}

TEST(Merge, LeavesOutTrianglesWithoutArea) {
  MaterialMesh thin = laid_out(Material::kAsphalt, ColourSource::kByMarkingAtlas);
  thin.mesh.triangles = {{0, 1, 1}};
  EXPECT_TRUE(merged({thin}).empty());
}

}  // namespace
}  // namespace citykiln::bake

#include "preview/scene/facade_atlas_texture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/materials/material.h"
#include "preview/scene/world.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

using materials::Material;
using materials::TextureImage;

constexpr double kAtlasTexel_m = 0.5;

// Black and rough on the left, white, smooth and half metal on the right.
impostor::Atlas halves() {
  impostor::Atlas atlas{{kAtlasTexel_m, 64, 64, {}}, {kAtlasTexel_m, 64, 64, {}}, {}, {}};
  for (int i = 0; i < 64 * 64; ++i) {
    const bool is_left = i % 64 < 32;
    atlas.colour.texels.push_back(is_left ? TextureImage::Texel{} : TextureImage::Texel{255, 255, 255});
    atlas.surface.texels.push_back(is_left ? TextureImage::Texel{255, 255, 0} : TextureImage::Texel{255, 51, 128});
  }
  return atlas;
}

// 32 m each way, of which a metre is so many metres of the atlas.
bake::BakedTile textured_faces(double of_atlas_m) {
  bake::Primitive face = floor({0, 0, 0}, {32, 32, 0}, Material::kPaint);
  for (const bake::Float3& p : face.positions)
    face.uvs.push_back({static_cast<float>(p[0] * of_atlas_m), static_cast<float>(p[1] * of_atlas_m)});
  face.colour_source = materials::ColourSource::kByAtlas;
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.primitives = {face};
  tile.facade_atlas = halves();
  return tile;
}

Hit seen_at(const bake::BakedTile& tile, Vec2 at, double spread_rad) {
  const std::vector tiles = {tile};
  const World world(tiles, {});
  const auto hit = world.first_hit({at.x, at.y, 10}, {0, 0, -1}, spread_rad);
  EXPECT_TRUE(hit);
  return *hit;
}

TEST(FacadeAtlasTexture, SaysColourRoughnessAndMetalness) {
  const Hit left = seen_at(textured_faces(1), {8, 16}, 0), right = seen_at(textured_faces(1), {24, 16}, 0);
  EXPECT_NEAR(left.albedo[0], 0, 1e-6);
  EXPECT_NEAR(left.roughness, 1, 1e-6);
  EXPECT_NEAR(right.albedo[0], 1, 1e-6);
  EXPECT_NEAR(right.roughness, 0.2, 1e-6);
  EXPECT_EQ(left.metallic, 0);
  EXPECT_NEAR(right.metallic, 128 / 255.0, 1e-6);
}

// u runs east here and v north, so a normal against v points south.
TEST(FacadeAtlasTexture, SaysWhichWayItLeans) {
  bake::BakedTile tile = textured_faces(1);
  EXPECT_NEAR(seen_at(tile, {8, 16}, 0).shading_normal.z, 1, 1e-6);
  tile.facade_atlas.normal = {kAtlasTexel_m, 64, 64, std::vector<TextureImage::Texel>(64 * 64, {37, 128, 218})};
  const Vec3 normal = seen_at(tile, {8, 16}, 0).shading_normal;
  EXPECT_NEAR(normal.x, -std::sqrt(0.5), 0.005);
  EXPECT_NEAR(normal.y, 0, 0.005);
  EXPECT_NEAR(normal.z, std::sqrt(0.5), 0.005);
}

TEST(FacadeAtlasTexture, FlatPartsOfNormalMapsAreFlat) {
  bake::BakedTile tile = textured_faces(1);
  const Vec3 without = seen_at(tile, {8, 16}, 0).shading_normal;
  tile.facade_atlas.normal = {kAtlasTexel_m, 64, 64, std::vector<TextureImage::Texel>(64 * 64, {128, 128, 255})};
  EXPECT_EQ(seen_at(tile, {8, 16}, 0).shading_normal, without);
}

// Two faces that each show one half: seen so flat that a ray covers many metres, each keeps the colour of its half.
TEST(FacadeAtlasTexture, AFaceShowsItsOwnPictureAlone) {
  bake::BakedTile tile = textured_faces(1);
  bake::Primitive& faces = tile.primitives[0];
  faces = floor({0, 0, 0}, {16, 32, 0}, Material::kPaint);
  add_quad(faces, {16, 0, 0}, {32, 0, 0}, {32, 32, 0}, {16, 32, 0});
  for (const bake::Float3& p : faces.positions) faces.uvs.push_back({p[0], p[1]});
  faces.colour_source = materials::ColourSource::kByAtlas;
  const std::vector tiles = {tile};
  const World world(tiles, {});
  const auto seen = [&](double x) {
    const Vec3 eye{x - 50, 16, 2}, at{x, 16, 0};
    return world.first_hit(eye, unit(at - eye), 0.01)->albedo[0];
  };
  EXPECT_NEAR(seen(14), 0, 1e-6);
  EXPECT_NEAR(seen(18), 1, 1e-6);
}

// Neighbours on an atlas are unrelated.
TEST(FacadeAtlasTexture, FromAfarPicturesStayApart) {
  EXPECT_NEAR(seen_at(textured_faces(1), {13.5, 16}, 3).albedo[0], 0, 1e-6);
  EXPECT_NEAR(seen_at(textured_faces(1), {18.5, 16}, 3).albedo[0], 1, 1e-6);
}

// On joined atlases a far tile's texel of 12.5 m is as large as a near one's of 0.5 m.
TEST(FacadeAtlasTexture, IsSmoothedByTexelsNotMetres) {
  const Hit near_edge = seen_at(textured_faces(0.04), {31, 16}, 0.01);
  EXPECT_NEAR(near_edge.albedo[0], 0, 1e-6);
}

}  // namespace
}  // namespace citykiln::preview

// Rays pass through holes of cutouts; leaves transmit light.
#include "preview/scene/cutout_texture.h"

#include <gtest/gtest.h>

#include "preview/path_trace.h"
#include "preview/scene/world.h"
#include "tests/preview/solids.h"

namespace citykiln::preview {
namespace {

// A vertical square of 2 m over the origin, of which the left half is opaque.
bake::BakedTile half_leaf() {
  bake::Primitive leaf{materials::Material::kBroadLeaf, {}, {}, {}, {}, {}};
  add_quad(leaf, {-1, 0, 0}, {1, 0, 0}, {1, 0, 2}, {-1, 0, 2});
  leaf.features.clear();
  leaf.uvs = {{0, 2}, {2, 2}, {2, 0}, {0, 0}};
  leaf.colour_source = materials::ColourSource::kByCutout;
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.instanced = {{"leaf", {leaf}, {{0, 0, 0}}, {{0, 0, 0, 1}}, {1}, {0}}};
  tile.instanced[0].cutout =
      impostor::Cutout{{1, 2, 2, std::vector<materials::TextureImage::Texel>(4, {255, 0, 0})}, {255, 0, 255, 0}, {}};
  return tile;
}

TEST(CutoutTexture, IsThereOnOneSideOfTheMiddle) {
  const bake::BakedTile tile = half_leaf();
  const CutoutTexture texture(*tile.instanced[0].cutout);
  EXPECT_TRUE(texture.is_there({0.6, 1}));
  EXPECT_FALSE(texture.is_there({1.2, 1}));
  EXPECT_FALSE(texture.is_there({-40, 1}));
}

TEST(CutoutTexture, LetsRaysAndShadowsThrough) {
  const bake::BakedTile tile = half_leaf();
  const World world(std::span(&tile, 1), {});
  const auto hit = world.first_hit({-0.5, -5, 1}, {0, 1, 0});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->albedo[0], 1, 1e-3);
  EXPECT_NEAR(hit->albedo[1], 0, 1e-3);
  EXPECT_GT(hit->translucency, 0);
  EXPECT_FALSE(world.first_hit({0.5, -5, 1}, {0, 1, 0}));
  EXPECT_TRUE(world.is_blocked({-0.5, -5, 1}, {0, 1, 0}));
  EXPECT_FALSE(world.is_blocked({0.5, -5, 1}, {0, 1, 0}));
}

// The map's normal leans along u, east; from either side it is east.
TEST(CutoutTexture, KeepsItsNormalsSeenFromBehind) {
  bake::BakedTile tile = half_leaf();
  impostor::Cutout cutout = *tile.instanced[0].cutout;
  cutout.normal = {2, 1, 1, {{218, 128, 218}}};
  tile.instanced[0].cutout = std::move(cutout);
  const World world(std::span(&tile, 1), {});
  const auto before = world.first_hit({-0.5, -5, 1}, {0, 1, 0}, 1e-3),
             behind = world.first_hit({-0.5, 5, 1}, {0, -1, 0}, 1e-3);
  ASSERT_TRUE(before && behind);
  EXPECT_NEAR(before->shading_normal.x, std::sqrt(0.5), 0.02);
  EXPECT_NEAR(behind->shading_normal.x, std::sqrt(0.5), 0.02);
  EXPECT_NEAR(before->shading_normal.y, -std::sqrt(0.5), 0.02);
  EXPECT_NEAR(behind->shading_normal.y, std::sqrt(0.5), 0.02);
}

}  // namespace
}  // namespace citykiln::preview

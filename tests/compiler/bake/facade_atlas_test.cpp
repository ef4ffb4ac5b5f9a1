#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/bake/bake.h"

namespace citykiln::bake {
namespace {

constexpr double kAtlasTile_m = 256, kAtlasGround_m = 30;

buildings::Building block(std::int64_t id, Vec2 at) {
  buildings::Building house;
  house.id = {{OsmType::kWay, id}, 0};
  house.footprint.outer = {at, at + Vec2{30, 0}, at + Vec2{30, 12}, at + Vec2{0, 12}};
  house.bottom_m = house.floor_m = kAtlasGround_m, house.top_m = kAtlasGround_m + 18;
  house.levels = 6;
  house.wall = house.roof = materials::Material::kConcrete;
  house.style = buildings::Style::kPanelBlock;
  return house;
}

scene::Scene with_blocks(std::int64_t count) {
  scene::Scene scene;
  scene.header.extent = {{0, 0}, {kAtlasTile_m, kAtlasTile_m}};
  scene.header.tile_m = kAtlasTile_m;
  const auto rules = buildings::shipped_rules();
  scene.header.rules.assign(rules.begin(), rules.end());
  scene::Chunk& chunk = scene.chunks.emplace_back();
  chunk.heights = {{-64, -64}, {64, 64}, 7, 7, {}, 0};
  chunk.heights.heights.assign(7 * 7, static_cast<std::int32_t>(kAtlasGround_m / map::kHeightQuantum_m));
  for (std::int64_t i = 0; i < count; ++i)
    chunk.buildings.push_back(block(i + 1, {20.0, 20.0 + 30 * static_cast<double>(i)}));
  return scene;
}

std::vector<BakedTile> baked(const scene::Scene& scene, const std::vector<double>& tolerances_m) {
  Report report;
  return bake(scene.header, scene.chunks[0], tolerances_m, 2, report);
}

// The tile's faces on the facade atlas.
const Primitive* textured_faces(const BakedTile& tile) {
  for (const Primitive& p : tile.primitives)
    if (p.colour_source == materials::ColourSource::kByAtlas) return &p;
  return nullptr;
}

TEST(FacadeAtlas, FacadesLieOnTheTilesAtlas) {
  for (const BakedTile& tile : baked(with_blocks(5), {0.5, 2.5})) {
    const materials::TextureImage& colour = tile.facade_atlas.colour;
    ASSERT_FALSE(colour.texels.empty());
    EXPECT_EQ(colour.texel_m, tile.tolerance_m);
    const Primitive* facades = textured_faces(tile);
    ASSERT_NE(facades, nullptr);
    EXPECT_FALSE(facades->uvs.empty());
    for (const Float2& uv : facades->uvs) {
      EXPECT_TRUE(uv[0] > 0 && uv[0] < colour.columns * colour.texel_m);
      EXPECT_TRUE(uv[1] > 0 && uv[1] < colour.rows * colour.texel_m);
    }
  }
}

// Where in their texels the uvs of a house lie, in eighths, sorted: pictures begin at whole texels.
std::vector<std::array<int, 2>> eighths_of(const BakedTile& tile, OsmId house) {
  std::vector<std::array<int, 2>> all;
  const Primitive& faces = *textured_faces(tile);
  const auto eighth = [&](float at_m) {
    return static_cast<int>(std::lround(8 * at_m / tile.facade_atlas.colour.texel_m)) % 8;
  };
  for (std::size_t i = 0; i < faces.uvs.size(); ++i)
    if (tile.features[faces.features[i]] == house) all.push_back({eighth(faces.uvs[i][0]), eighth(faces.uvs[i][1])});
  std::ranges::sort(all);
  return all;
}

// Widths that end halfway between two steps of the grid of uvs.
TEST(FacadeAtlas, UvsRoundAlikeWhereverThePictureLies) {
  scene::Scene scene = with_blocks(7);
  for (buildings::Building& house : scene.chunks[0].buildings) {
    const double wider_m = 0.05 + static_cast<double>(house.id.osm.id) * 0.1;
    for (Vec2& corner : house.footprint.outer)
      if (corner.x > 25) corner.x += wider_m;
  }
  const BakedTile together = baked(scene, {0.8}).front();
  for (const buildings::Building& house : scene.chunks[0].buildings) {
    scene::Scene alone = scene;
    alone.chunks[0].buildings = {house};
    EXPECT_EQ(eighths_of(together, house.id.osm), eighths_of(baked(alone, {0.8}).front(), house.id.osm));
  }
}

TEST(FacadeAtlas, ShineByNight) {
  scene::Scene scene = with_blocks(2);
  EXPECT_TRUE(baked(scene, {0.5}).front().facade_atlas.emission.texels.empty());
  scene.header.sky.to_sun = {0, -0.96, -0.28};
  const impostor::Atlas atlas = baked(scene, {0.5}).front().facade_atlas;
  EXPECT_EQ(atlas.emission.texels.size(), atlas.colour.texels.size());
}

TEST(FacadeAtlas, LevelsWithAllFramesHaveNone) {
  const BakedTile tile = std::move(baked(with_blocks(2), {0.02}).front());
  EXPECT_EQ(tile.facade_atlas, impostor::Atlas{});
  EXPECT_EQ(textured_faces(tile), nullptr);
}

TEST(FacadeAtlas, EveryHouseIsThereThoughAllOfItIsPictures) {
  const scene::Scene scene = with_blocks(5);
  Report report;
  const double tolerance_m = 2.5;
  const auto tiles = bake(scene.header, scene.chunks[0], std::span(&tolerance_m, 1), 1, report);
  EXPECT_EQ(report.account("bake", "building").out, 5u);
  EXPECT_EQ(tiles[0].features.size(), 6u);
}

TEST(FacadeAtlas, LevelsTogetherAreTheLevelsAlone) {
  const scene::Scene scene = with_blocks(4);
  const std::vector<BakedTile> together = baked(scene, {0.1, 0.5, 2.5, 12.5});
  EXPECT_FALSE(together.empty());
  for (const BakedTile& tile : together) EXPECT_EQ(baked(scene, {tile.tolerance_m}).front(), tile);
}

}  // namespace
}  // namespace citykiln::bake

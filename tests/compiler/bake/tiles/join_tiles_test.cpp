#include "compiler/bake/tiles/join_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/materials/texture_cache.h"

namespace citykiln::bake {
namespace {

OsmId way_id(std::int64_t id) { return {OsmType::kWay, id}; }

/// One triangle of one feature, and one instance, at the tile's origin.
BakedTile tile_at(Vec3 origin, OsmId feature, double error_m) {
  Primitive primitive{materials::Material{},
                      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.25f}},
                      {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                      {},
                      {1, 1, 1},
                      {{0, 1, 2}}};
  primitive.colours.assign(3, materials::kNoTint);
  Primitive shared = primitive;
  shared.features.clear();
  BakedTile tile{{0, 0}, origin, 0.1, error_m, {OsmId{}, feature}, {primitive}, {}};
  tile.plant_error_m = error_m * 4;
  tile.instanced = {{"Tree", {shared}, {{2, 2, 0}}, {{0, 0, 0, 1}}, {5}, {1}}};
  return tile;
}

Vec3 place_of(const BakedTile& tile, std::size_t vertex) {
  const Float3& p = tile.primitives.front().positions[vertex];
  return Vec3{p[0], p[1], p[2]} + tile.origin;
}

TEST(JoinTiles, KeepsEveryVertexWhereItWas) {
  const std::vector tiles = {tile_at({1024, 0, 7}, way_id(5), 0.1), tile_at({-1024, 512, 900}, way_id(3), 0.2)};
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(place_of(*joined, t * 3 + v), place_of(tiles[t], v));
  }
  EXPECT_EQ(joined->primitives.size(), 1u);
  EXPECT_EQ(joined->primitives[0].triangles[1], (std::array<std::uint32_t, 3>{3, 4, 5}));
  EXPECT_EQ(joined->error_m, 0.2);
  EXPECT_EQ(joined->plant_error_m, 0.8);
}

TEST(JoinTiles, KeepsTheFeatureOfEveryTriangleAndInstance) {
  const std::vector tiles = {tile_at({0, 0, 0}, way_id(5), 0), tile_at({1024, 0, 0}, way_id(3), 0)};
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->features, (std::vector<OsmId>{OsmId{}, way_id(3), way_id(5)}));
  EXPECT_EQ(joined->primitives[0].features, (std::vector<std::uint32_t>{2, 2, 2, 1, 1, 1}));
  EXPECT_EQ(joined->instanced[0].features, (std::vector<std::uint32_t>{2, 1}));
}

TEST(JoinTiles, KeepsWhatTheTileThatKnowsMostSaysOfAFeature) {
  std::vector tiles = {tile_at({0, 0, 0}, way_id(5), 0), tile_at({1024, 0, 0}, way_id(5), 0)};
  tiles[0].attributes = {{}, {"Building", "", 0}};
  tiles[1].attributes = {{}, {"Church", "St. Anna", 31.5f}};
  for (int i = 0; i < 2; ++i) {
    const Result<BakedTile> joined = join_tiles(tiles);
    ASSERT_TRUE(joined);
    EXPECT_EQ(joined->attributes, (std::vector<FeatureAttributes>{{}, {"Church", "St. Anna", 31.5f}}));
    std::ranges::reverse(tiles);
  }
}

TEST(JoinTiles, KeepsWhatAnyTileKnowsToBeAssumed) {
  std::vector tiles = {tile_at({0, 0, 0}, way_id(5), 0), tile_at({1024, 0, 0}, way_id(5), 0)};
  tiles[0].attributes = {{}, {"Church", "", 31.5f}};
  tiles[1].attributes = {{}, {"Building", "", 0, {}, bit_of(Assumption::kHeights)}};
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->attributes[1].assumed, bit_of(Assumption::kHeights));
  EXPECT_EQ(joined->attributes[1].kind, "Church");
}

TEST(JoinTiles, KeepsMeshesWithDifferentCutoutsApart) {
  std::vector tiles = {tile_at({0, 0, 0}, way_id(5), 0), tile_at({1024, 0, 0}, way_id(3), 0),
                       tile_at({2048, 0, 0}, way_id(4), 0)};
  const materials::TextureImage sheet{0.5, 1, 1, {{1, 2, 3}}};
  for (BakedTile& tile : tiles) tile.instanced[0].cutout = impostor::Cutout{sheet, {255}, {}};
  tiles[1].instanced[0].cutout = impostor::Cutout{sheet, {0}, {}};
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->instanced.size(), 2u);
  EXPECT_EQ(joined->instanced[0].translations.size(), 2u);
  EXPECT_EQ(joined->instanced[1].cutout, tiles[1].instanced[0].cutout);
}

TEST(JoinTiles, HasEachMaterialsTextureOnceInOrder) {
  using materials::Material;
  std::vector tiles = {tile_at({0, 0, 0}, way_id(5), 0), tile_at({1024, 0, 0}, way_id(3), 0)};
  const Material one[] = {Material::kGrass, Material::kRock}, other[] = {Material::kMeadow, Material::kRock};
  const materials::TextureCache cache(1);
  tiles[0].textures = cache.textures_of(one, 0.1), tiles[1].textures = cache.textures_of(other, 0.1);
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  const Material all[] = {Material::kGrass, Material::kMeadow, Material::kRock};
  EXPECT_EQ(joined->textures, cache.textures_of(all, 0.1));
}

TEST(JoinTiles, SharesMeshesThatAreTheSame) {
  std::vector tiles = {tile_at({0, 0, 0}, way_id(5), 0), tile_at({1024, 0, 0}, way_id(3), 0),
                       tile_at({2048, 0, 0}, way_id(4), 0)};
  tiles[2].instanced[0].primitives[0].triangles.clear();
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->instanced.size(), 2u);
  EXPECT_EQ(joined->instanced[0].translations, (std::vector<Float3>{{2, 2, 0}, {1026, 2, 0}}));
}

/// With a road on a sheet of one colour, and one that is not on it.
BakedTile marked_at(Vec3 origin, std::uint8_t grey) {
  BakedTile tile = tile_at(origin, way_id(5), 0);
  for (const auto colour_source : {materials::ColourSource::kByMaterial, materials::ColourSource::kByMarkingAtlas}) {
    tile.primitives.push_back(tile.primitives[0]);
    tile.primitives.back().uvs = {{0, 7}, {0.5f, 7}, {1, 9}};
    tile.primitives.back().colour_source = colour_source;
  }
  tile.instanced[0].primitives.push_back(tile.primitives.back());
  tile.instanced[0].primitives.back().features.clear();
  tile.marking_atlas = {0.5, 2, 1, {{grey, grey, grey}, {grey, grey, grey}}};
  return tile;
}

TEST(JoinTiles, ShowsEveryRoadWithItsOwnMarkings) {
  const std::vector tiles = {marked_at({0, 0, 0}, 50), tile_at({1024, 0, 0}, way_id(3), 0),
                             marked_at({2048, 0, 0}, 200)};
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->primitives.size(), 3u);
  const auto shown = [&](const Primitive& road, std::size_t v) {
    return joined->marking_atlas.texels.at(static_cast<std::size_t>(road.uvs[v][0] / 0.5))[0];
  };
  const Primitive& marked = joined->primitives[2];
  ASSERT_EQ(marked.uvs.size(), 6u);
  for (const std::size_t v : {0u, 1u}) EXPECT_EQ(shown(marked, v), 50);
  for (const std::size_t v : {3u, 4u}) EXPECT_EQ(shown(marked, v), 200);
  EXPECT_EQ(marked.uvs[5][1], 9);
  // places along a road without markings are no places on a sheet
  EXPECT_EQ(joined->primitives[1].uvs[3], tiles[2].primitives[1].uvs[0]);
  ASSERT_EQ(joined->instanced.size(), 3u);
  EXPECT_EQ(shown(joined->instanced[0].primitives[1], 0), 50);
  EXPECT_EQ(shown(joined->instanced[2].primitives[1], 0), 200);
}

TEST(JoinTiles, HasOnePrimitiveForEachKeySorted) {
  const std::vector tiles = {tile_at({1024, 0, 0}, way_id(3), 0), marked_at({0, 0, 0}, 50),
                             marked_at({2048, 0, 0}, 50)};
  const Result<BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->primitives.size(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(joined->primitives, {}, key_of));
  EXPECT_EQ(joined->marking_atlas, tiles[1].marking_atlas);
}

TEST(JoinTiles, StatesTheFinestToleranceAndLargestPixelErrorOfAView) {
  std::vector parts = {tile_at({0, 0, 0}, way_id(5), 0.1), tile_at({0, 0, 0}, way_id(3), 0.2)};
  parts[1].tolerance_m = 0.05;
  for (BakedTile& part : parts) part.viewpoint = Viewpoint{{1, 2, 3}, 900, part.error_m * 4};
  const Result<BakedTile> joined = join_tiles(parts);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->tolerance_m, 0.05);
  EXPECT_EQ(joined->viewpoint, parts[1].viewpoint);
}

TEST(JoinTiles, RefusesTilesBeyondFloat32Precision) {
  EXPECT_FALSE(join_tiles(std::vector{tile_at({0, 0, 0}, way_id(1), 0), tile_at({16384, 0, 0}, way_id(2), 0)}));
}

TEST(JoinTiles, LeavesASingleTileUnchanged) {
  for (const BakedTile& tile : {tile_at({1024, 0, 7}, way_id(5), 0.1), marked_at({1024, 0, 7}, 50)}) {
    const std::vector tiles = {tile};
    EXPECT_EQ(*join_tiles(tiles), tiles[0]);
  }
}

}  // namespace
}  // namespace citykiln::bake

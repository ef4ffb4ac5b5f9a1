#include "compiler/commands/join_tiles.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

OsmId way(std::int64_t id) { return {OsmType::kWay, id}; }

/// One triangle of one feature, and one instance, at the tile's origin.
bake::BakedTile tile_at(Vec3 origin, OsmId feature, double error_m) {
  bake::Primitive primitive{materials::Material{},
                            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.25f}},
                            {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                            {},
                            {1, 1, 1},
                            {{0, 1, 2}}};
  primitive.colours.assign(3, materials::kNoTint);
  bake::Primitive shared = primitive;
  shared.features.clear();
  bake::BakedTile tile{{0, 0}, origin, 0.1, error_m, {OsmId{}, feature}, {primitive}, {}};
  tile.instanced = {{"Tree", {shared}, {{2, 2, 0}}, {{0, 0, 0, 1}}, {5}, {1}}};
  return tile;
}

Vec3 place_of(const bake::BakedTile& tile, std::size_t vertex) {
  const bake::Float3& p = tile.primitives.front().positions[vertex];
  return Vec3{p[0], p[1], p[2]} + tile.origin;
}

TEST(JoinTiles, KeepsEveryVertexWhereItWas) {
  const std::vector tiles = {tile_at({1024, 0, 7}, way(5), 0.1), tile_at({-1024, 512, 900}, way(3), 0.2)};
  const Result<bake::BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(place_of(*joined, t * 3 + v), place_of(tiles[t], v));
  }
  EXPECT_EQ(joined->primitives.size(), 1u);
  EXPECT_EQ(joined->primitives[0].triangles[1], (std::array<std::uint32_t, 3>{3, 4, 5}));
  EXPECT_EQ(joined->error_m, 0.2);
}

TEST(JoinTiles, KeepsWhoseEverythingIs) {
  const std::vector tiles = {tile_at({0, 0, 0}, way(5), 0), tile_at({1024, 0, 0}, way(3), 0)};
  const Result<bake::BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->features, (std::vector<OsmId>{OsmId{}, way(3), way(5)}));
  EXPECT_EQ(joined->primitives[0].features, (std::vector<std::uint32_t>{2, 2, 2, 1, 1, 1}));
  EXPECT_EQ(joined->instanced[0].features, (std::vector<std::uint32_t>{2, 1}));
}

TEST(JoinTiles, SharesMeshesThatAreTheSame) {
  std::vector tiles = {tile_at({0, 0, 0}, way(5), 0), tile_at({1024, 0, 0}, way(3), 0),
                       tile_at({2048, 0, 0}, way(4), 0)};
  tiles[2].instanced[0].primitives[0].triangles.clear();
  const Result<bake::BakedTile> joined = join_tiles(tiles);
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->instanced.size(), 2u);
  EXPECT_EQ(joined->instanced[0].translations, (std::vector<bake::Float3>{{2, 2, 0}, {1026, 2, 0}}));
}

TEST(JoinTiles, RefusesWhatFloat32CannotHold) {
  EXPECT_FALSE(join_tiles(std::vector{tile_at({0, 0, 0}, way(1), 0), tile_at({16384, 0, 0}, way(2), 0)}));
}

TEST(JoinTiles, OfOneIsThatOne) {
  const std::vector tiles = {tile_at({1024, 0, 7}, way(5), 0.1)};
  EXPECT_EQ(*join_tiles(tiles), tiles[0]);
}

}  // namespace
}  // namespace citykiln::commands

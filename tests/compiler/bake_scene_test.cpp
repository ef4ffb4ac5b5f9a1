#include "compiler/bake_scene.h"

#include <gtest/gtest.h>

#include "compiler/pipeline.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

constexpr double kCoarse_m = 12.5;

scene::Scene town_in_small_tiles() {
  CompileSpec spec;
  spec.map_path = source_file("examples/town/town.osm");
  spec.tile_m = 512;
  Result<CompileResult> compiled = compile(spec, [](auto&&...) {});
  EXPECT_TRUE(compiled);
  return compiled ? std::move(compiled->scene) : scene::Scene{};
}

TEST(BakeTiles, AreThoseOfBakeSceneInTheOrderOfTheChunks) {
  const scene::Scene scene = town_in_small_tiles();
  ASSERT_GT(scene.chunks.size(), 3u);
  std::vector<bake::BakedTile> one_by_one;
  Report ignored;
  const Result<Done> done = bake_scene(
      scene, std::vector{kCoarse_m}, 1, ignored, [](auto&&...) {},
      [&](const bake::BakedTile& tile, std::size_t) -> Result<Done> {
        one_by_one.push_back(tile);
        return Done{};
      });
  ASSERT_TRUE(done);
  const std::vector<bake::BakedTile> tiles = bake_tiles(scene, kCoarse_m, 3);
  EXPECT_EQ(tiles, one_by_one);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    EXPECT_EQ(tiles[i].tile, scene.chunks[i].tile);
    EXPECT_FALSE(tiles[i].primitives.empty());
  }
}

}  // namespace
}  // namespace citykiln

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/exporters/gltf/glb_json.h"
#include "tests/test_files.h"

namespace citykiln::exporters {
namespace {

TEST(Glb, ReadsBackWhatItWroteForEachTargetAndSplit) {
  for (std::uint32_t seed = 0, seeds = quick_or_full(3, 12); seed < seeds; ++seed)
    for (const GlbOptions& options : kAll) {
      for (const BakedTile& tile :
           {made_tile(seed), made_marked_tile(seed), made_facade_tile(seed), made_textured_tile(seed)}) {
        const auto back = decoded(encoded(tile, options));
        ASSERT_TRUE(back) << refusal(back);
        ASSERT_EQ(*back, tile);
      }
    }
}

TEST(Glb, TextureCoordinatesAreInUnitsOfTheImageWithoutATransform) {
  const BakedTile tile = made_facade_tile(1);
  const Bytes glb = encoded(tile, kNodes);
  const auto gltf = nlohmann::json::parse(json_of(glb));
  EXPECT_FALSE(gltf.contains("extensionsRequired"));
  EXPECT_EQ(json_of(glb).find("KHR_texture_transform"), std::string::npos);
  const auto atlas = std::ranges::find_if(
      tile.primitives, [](const bake::Primitive& p) { return p.colour_source == materials::ColourSource::kByAtlas; });
  ASSERT_NE(atlas, tile.primitives.end());
  const auto& primitive = gltf["meshes"][0]["primitives"][static_cast<std::size_t>(atlas - tile.primitives.begin())];
  const std::vector<float> uvs = floats_of(glb, gltf, primitive["attributes"]["TEXCOORD_0"].get<std::size_t>());
  ASSERT_EQ(uvs.size(), 2 * atlas->uvs.size());
  const materials::TextureImage& image = tile.facade_atlas.colour;
  for (std::size_t i = 0; i < atlas->uvs.size(); ++i) {
    EXPECT_FLOAT_EQ(uvs[2 * i], static_cast<float>(atlas->uvs[i][0] / (image.columns * image.texel_m)));
    EXPECT_FLOAT_EQ(uvs[2 * i + 1], static_cast<float>(atlas->uvs[i][1] / (image.rows * image.texel_m)));
  }
}

TEST(Glb, WhiteColoursAreLeftOut) {
  BakedTile tile = made_tile(1);
  bake::Primitive& first = tile.primitives.front();
  std::ranges::fill(first.colours, materials::kNoTint);
  const auto has_colours = [&] {
    return gltf_of(tile, kNodes)["meshes"][0]["primitives"][0]["attributes"].contains("COLOR_0");
  };
  EXPECT_FALSE(has_colours());
  const auto back = decoded(encoded(tile, kNodes));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(*back, tile);
  first.colours.back() = {254, 255, 255, 255};
  EXPECT_TRUE(has_colours());
}

TEST(Glb, BothWaysOfInstancingAreOneTile) {
  const auto with_extension = decoded(encoded(made_tile(1), kExtension)),
             with_nodes = decoded(encoded(made_tile(1), kNodes));
  ASSERT_TRUE(with_extension && with_nodes);
  EXPECT_EQ(*with_extension, *with_nodes);
}

TEST(Glb, SameTileSameBytes) {
  for (const GlbOptions& options : kAll) EXPECT_EQ(encoded(made_tile(1), options), encoded(made_tile(1), options));
}

TEST(Glb, TheOriginIsNotRoundedToSinglePrecision) {
  BakedTile tile = made_tile(1);
  tile.origin = {16777217, -16777219, 4097};
  const auto back = decoded(encoded(tile, kExtension));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(back->origin, tile.origin);
}

TEST(Glb, TellsForWhichEyeItWasMade) {
  BakedTile tile = made_tile(1);
  tile.viewpoint = bake::Viewpoint{{0.1, -16777219.25, 4097}, 869.1171875, 0.96};
  const auto back = decoded(encoded(tile, kExtension));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(back->viewpoint, tile.viewpoint);
}

TEST(Glb, MoreCornersThan16BitsCount) {
  std::mt19937 dice(1);
  BakedTile tile = made_tile(1);
  for (const std::uint32_t corners : {65533u, 65534u, 65535u, 65538u}) {
    tile.primitives = {made_primitive(dice, materials::Material::kRock, corners, 4)};
    const auto back = decoded(encoded(tile, kExtension));
    ASSERT_TRUE(back) << refusal(back);
    EXPECT_EQ(*back, tile) << corners;
  }
}

TEST(Glb, ATileWithoutGroundOrInstancesIsWhole) {
  BakedTile bare = made_tile(1), trees = made_tile(1);
  bare.instanced.clear(), trees.primitives.clear();
  for (const BakedTile& tile : {bare, trees}) {
    const auto back = decoded(encoded(tile, kNodes));
    ASSERT_TRUE(back) << refusal(back);
    EXPECT_EQ(*back, tile);
  }
}

}  // namespace
}  // namespace citykiln::exporters

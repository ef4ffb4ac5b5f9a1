#include "exporters/usd/encode_level.h"

#include <gtest/gtest.h>

#include "exporters/gltf/leaf_backs.h"
#include "exporters/usd/read_layer.h"
#include "tests/exporters/made_tile.h"

namespace citykiln::exporters {
namespace {

scene::Header made_header() {
  scene::Header header;
  header.origin = {7.42, 43.73};
  header.attributions = {"© OpenStreetMap contributors", "heights \"x\" \\ 2026"};
  return header;
}

UsdReadLayer read(const UsdLevel& level) {
  Result<UsdReadLayer> layer = read_usd_layer(level.layer, "layer");
  EXPECT_TRUE(layer) << layer.error().message;
  return layer ? *layer : UsdReadLayer{};
}

std::vector<bake::BakedTile> made_tiles() {
  std::vector<bake::BakedTile> tiles;
  for (std::uint32_t seed = 0; seed < 3; ++seed)
    for (const auto make : {made_tile, made_marked_tile, made_facade_tile, made_textured_tile}) {
      tiles.push_back(make(seed));
      std::ranges::stable_sort(tiles.back().primitives, {}, &bake::Primitive::layer);
      std::ranges::stable_sort(tiles.back().instanced, {}, [](const auto& m) { return layer_of(m); });
    }
  return tiles;
}

TEST(UsdLevel, TextAndCrateHaveTheSameContent) {
  for (const bake::BakedTile& tile : made_tiles()) {
    const UsdReadLayer text = read(encode_level(tile, made_header(), "../textures/", UsdForm::kText));
    const UsdReadLayer crate = read(encode_level(tile, made_header(), "../textures/", UsdForm::kCrate));
    ASSERT_GT(text.prims.size(), 10u);
    ASSERT_EQ(text.prims.size(), crate.prims.size());
    for (std::size_t i = 0; i < text.prims.size(); ++i) ASSERT_EQ(text.prims[i], crate.prims[i]) << text.prims[i].path;
    EXPECT_EQ(text, crate);
  }
}

TEST(UsdLevel, HasEveryPrimitiveAndInstance) {
  for (const bake::BakedTile& tile : made_tiles()) {
    const UsdReadLayer layer = read(encode_level(tile, made_header(), ""));
    std::size_t corners = 0, instances = 0, expected_corners = 0, expected_instances = 0;
    for (const UsdReadPrim& prim : layer.prims) {
      if (prim.type == "Mesh") corners += prim.values.at("faceVertexIndices").numbers.size();
      if (prim.type == "PointInstancer") instances += prim.values.at("protoIndices").numbers.size();
    }
    const auto count = [&](const bake::Primitive& p) {
      expected_corners += 3 * p.triangles.size() * (has_backs(p) ? 2 : 1);
    };
    for (const bake::Primitive& p : tile.primitives) count(p);
    for (const bake::InstancedMesh& mesh : tile.instanced) {
      for (const bake::Primitive& p : mesh.primitives) count(p);
      expected_instances += mesh.translations.size();
    }
    EXPECT_EQ(corners, expected_corners);
    EXPECT_EQ(instances, expected_instances);
  }
}

TEST(UsdLevel, StatesErrorsOriginAndAttribution) {
  const bake::BakedTile tile = made_tile(1);
  const UsdReadLayer layer = read(encode_level(tile, made_header(), ""));
  const UsdReadPrim* root = prim_at(layer, "/tile");
  ASSERT_NE(root, nullptr);
  EXPECT_EQ(root->custom_data.at("error_m").numbers, std::vector{tile.error_m});
  EXPECT_EQ(root->custom_data.at("origin_m").numbers, (std::vector{tile.origin.x, tile.origin.y, tile.origin.z}));
  EXPECT_EQ(layer.custom_data.at("attribution").texts,
            std::vector<std::string>{"© OpenStreetMap contributors; heights \"x\" \\ 2026"});
  EXPECT_EQ(prim_at(layer, "/tile/features")->values.at("osm:name").texts[2], "Château «Ω»");
}

TEST(UsdLevel, NamesWhatIsAssumedWhereSomethingIs) {
  bake::BakedTile tile = made_tile(1);
  const auto features_of = [&] { return *prim_at(read(encode_level(tile, made_header(), "")), "/tile/features"); };
  EXPECT_FALSE(features_of().values.contains("osm:assumed"));
  tile.attributes[2].assumed = bit_of(Assumption::kPavements) | bit_of(Assumption::kLamps);
  EXPECT_EQ(features_of().values.at("osm:assumed").texts, (std::vector<std::string>{"", "", "pavements lamps", ""}));
}

TEST(UsdLevel, LeavesHaveTheMeanTintOfTheirMesh) {
  bake::BakedTile tile = made_facade_tile(2);
  bake::Primitive& leaves = tile.instanced.front().primitives.back();
  ASSERT_EQ(leaves.colour_source, materials::ColourSource::kByCutout);
  for (std::size_t i = 0; i < leaves.colours.size(); ++i)
    leaves.colours[i] = {static_cast<std::uint8_t>(i % 2 == 0 ? 51 : 153), 255, 0, 255};
  const UsdReadLayer layer = read(encode_level(tile, made_header(), ""));
  std::size_t found = 0;
  for (const UsdReadPrim& prim : layer.prims) {
    const auto scale = prim.values.find("inputs:scale");
    if (scale == prim.values.end() || scale->second.numbers[2] != 0) continue;
    ++found;
    EXPECT_NEAR(scale->second.numbers[0], 0.4, 1e-6);
    EXPECT_EQ(scale->second.numbers[1], 1);
  }
  EXPECT_EQ(found, 1u);
}

// One byte is another, or the end is missing.
TEST(UsdReader, DamageIsAnErrorOrAnotherLayer) {
  std::mt19937 dice(5);
  const bake::BakedTile tile = made_marked_tile(1);
  std::size_t errors = 0;
  for (const UsdForm form : {UsdForm::kText, UsdForm::kCrate}) {
    const std::vector<std::byte> whole = encode_level(tile, made_header(), "", form).layer;
    for (int i = 0; i < 1500; ++i) {
      std::vector<std::byte> bytes = whole;
      if (i % 4 == 0) bytes.resize(dice() % bytes.size());
      if (!bytes.empty()) bytes[dice() % bytes.size()] = static_cast<std::byte>(dice());
      errors += !read_usd_layer(bytes, "damaged");
    }
  }
  EXPECT_GT(errors, 1000u);
}

}  // namespace
}  // namespace citykiln::exporters

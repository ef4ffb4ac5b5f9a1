#include <gtest/gtest.h>

#include <algorithm>

#include "tests/exporters/gltf/glb_json.h"
#include "tests/test_files.h"

namespace citykiln::exporters {
namespace {

std::string marked_refusal_with(const std::string& text, const std::string& other) {
  return refusal_with(kExtension, text, other, made_marked_tile(1));
}

std::string textured_refusal_with(const std::string& text, const std::string& other) {
  return refusal_with(kExtension, text, other, made_textured_tile(1));
}

TEST(GlbDamage, EveryTruncationIsRefused) {
  for (const BakedTile& tile : {made_tile(2), made_marked_tile(2)}) {
    const Bytes bytes = encoded(tile, kExtension);
    ASSERT_FALSE(bytes.empty());
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_FALSE(decoded(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)))) << size;
  }
}

// Tiles have no checksum, so a changed byte may make another tile: one that can be written and read.
TEST(GlbDamage, AChangedByteIsRefusedOrMakesAnotherTile) {
  std::mt19937 dice(4);
  for (const GlbOptions& options : {kExtension, GlbOptions{.target = Target::kGodot}}) {
    const Bytes bytes = encoded(options.target == Target::kGodot ? made_tile(3) : made_marked_tile(3), options);
    ASSERT_FALSE(bytes.empty());
    for (std::size_t at = 0; at < bytes.size(); at += 1 + dice() % quick_or_full(20, 5)) {
      Bytes changed = bytes;
      changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
      const auto tile = decoded(changed);
      if (!tile) continue;
      for (const bake::Primitive& p : tile->primitives)
        for (const auto& triangle : p.triangles)
          for (const auto corner : triangle) ASSERT_LT(corner, p.positions.size()) << "byte " << at;
      const auto again = decoded(encoded(*tile, kExtension));
      ASSERT_TRUE(again) << "byte " << at << ": " << refusal(again);
      ASSERT_EQ(without_uvs(*again), without_uvs(*tile)) << "byte " << at;
    }
  }
}

TEST(GlbDamage, ABufferLongerThanTheFileIsRefused) {
  Bytes bytes = encoded(made_tile(1), kExtension);
  const std::size_t at = 20 + json_of(bytes).size();
  put_number(bytes, at, bytes.size() - at - 4);
  EXPECT_EQ(refusal(decoded(bytes)), "tile.glb: expected two chunks, JSON and its buffer, that fill the file");
}

TEST(GlbDamage, JsonNestedWithoutEndIsRefused) {
  const Bytes bytes = encoded(made_tile(1), kExtension);
  const std::string deep = std::string(500000, '['), end(500000, ']');
  EXPECT_EQ(refusal(decoded(with_json(bytes, "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep + end + "}"))),
            "tile.glb: expected JSON that is not nested deeper than glTF ever is");
  const std::string text = R"({"asset":{"version":"2.0"},"extras":"\")" + deep + "\"}";
  EXPECT_EQ(refusal(decoded(with_json(bytes, text))), "tile.glb: expected a node for the tile, and one buffer");
}

TEST(GlbDamage, OtherFilesAreNotOpened) {
  const std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"/etc/hostname"}]})";
  EXPECT_EQ(refusal(decoded(with_json(encoded(made_tile(1), kExtension), json))),
            "tile.glb: expected a buffer inside the file");
}

TEST(GlbDamage, ANodeWithoutMeshIsRefused) {
  const std::string expected = "tile.glb: expected each mesh in nodes that follow each other, in order";
  EXPECT_EQ(refusal_with(kNodes, "\"mesh\":1", "\"mess\":1"), expected);
  EXPECT_EQ(refusal_with(kNodes, "\"mesh\":1", "\"mesh\":0"), expected);
  EXPECT_EQ(refusal_with(kExtension, "\"mesh\":2", "\"mesh\":1"), expected);
}

TEST(GlbDamage, NumbersBeyondTheirTypeAreRefused) {
  EXPECT_EQ(refusal_with(kExtension, "\"tile\":[-3", "\"tile\":[-3e30"), "tile.glb: expected a whole number");
  EXPECT_EQ(refusal_with(kNodes, "\"translation\":[0.25", "\"translation\":[1e300"),
            "tile.glb: expected places in single precision");
}

TEST(GlbMarkingAtlasDamage, AMissingImageIsRefused) {
  const std::string expected = "tile.glb: expected an image, and uvs, for primitives that an image colours";
  EXPECT_EQ(marked_refusal_with("\"images\"", "\"imagos\""), expected);
  EXPECT_EQ(marked_refusal_with("\"name\":\"Grass\"", "\"name\":\"GrassMarked\""), expected);
}

TEST(GlbMarkingAtlasDamage, PlacesForOtherCornersAreRefused) {
  bake::BakedTile tile = made_marked_tile(1);
  tile.primitives.back().uvs.pop_back();
  EXPECT_EQ(refusal(decoded(encoded(tile, kExtension))), "tile.glb: expected as many values in each attribute");
}

TEST(GlbMarkingAtlasDamage, PlacesThatAreNotFiniteAreRefused) {
  for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    bake::BakedTile tile = made_marked_tile(1);
    tile.primitives.back().uvs.back()[1] = bad;
    EXPECT_EQ(refusal(decoded(encoded(tile, kExtension))), "tile.glb: expected finite numbers");
  }
}

TEST(GlbMarkingAtlasDamage, ASecondMarkingAtlasIsRefused) {
  const std::string images = images_of(made_marked_tile(1)), one = images.substr(1, images.size() - 2);
  EXPECT_EQ(marked_refusal_with(images, "[" + one + "," + one + "]"),
            "tile.glb: expected images named after materials, and one marking atlas at most");
}

TEST(GlbTextureDamage, PicturesOfNoMaterialTwiceOrOutOfOrderAreRefused) {
  const std::string named = "tile.glb: expected images named after materials, and one marking atlas at most",
                    once = "tile.glb: expected each material's pictures once, in order";
  EXPECT_EQ(textured_refusal_with("\"GrassColour\"", "\"GrossColour\""), named);
  EXPECT_EQ(textured_refusal_with("\"GrassColour\"", "\"Grass\""), named);
  EXPECT_EQ(textured_refusal_with("\"RockColour\"", "\"RockNormal\""), once);
  EXPECT_EQ(textured_refusal_with("\"WaterNormal\"", "\"GrassColour\""), once);
  EXPECT_EQ(textured_refusal_with("\"GrassColour\"", "\"StoneColour\""), once);
}

TEST(GlbTextureDamage, AChangedByteOfTheJsonIsRefusedOrMakesAnotherTile) {
  std::mt19937 dice(5);
  const Bytes bytes = encoded(made_textured_tile(3), kExtension);
  const std::size_t end = 20 + json_of(bytes).size();
  ASSERT_GT(end, 0u);
  for (std::size_t at = 0; at < end; at += 1 + dice() % quick_or_full(60, 12)) {
    Bytes changed = bytes;
    changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
    const auto tile = decoded(changed);
    if (!tile) continue;
    const auto again = decoded(encoded(*tile, kExtension));
    ASSERT_TRUE(again) << "byte " << at << ": " << refusal(again);
    ASSERT_EQ(without_uvs(*again), without_uvs(*tile)) << "byte " << at;
  }
}

TEST(GlbMarkingAtlasDamage, TexelsWithoutASizeAreRefused) {
  EXPECT_EQ(marked_refusal_with("\"texel_m\"", "\"texel_n\""),
            "tile.glb: expected the extras and extensions that citykiln writes");
  for (const char* bad : {"-0.", "0,\"other\":0."})
    EXPECT_EQ(marked_refusal_with("\"texel_m\":0.", std::string("\"texel_m\":") + bad),
              "tile.glb: expected texels with a size");
}

TEST(GlbMarkingAtlasDamage, APictureThatIsNoneIsRefused) {
  Bytes bytes = encoded(made_marked_tile(1), kExtension);
  const std::string signature = "\x89PNG", header = "IHDR";
  const auto find = [&](const std::string& word) {
    return std::search(bytes.begin(), bytes.end(), word.begin(), word.end(),
                       [](std::byte b, char c) { return b == static_cast<std::byte>(c); });
  };
  for (const std::string& word : {header, signature}) {
    const auto at = find(word);
    ASSERT_NE(at, bytes.end());
    *at ^= std::byte{1};
    EXPECT_EQ(refusal(decoded(bytes)).substr(0, 52), "tile.glb: expected a picture: expected a PNG picture");
  }
}

TEST(GlbMarkingAtlasDamage, APictureOutsideTheBufferIsRefused) {
  const std::string expected = "tile.glb: expected images inside the buffer, as citykiln writes them";
  const auto gltf = gltf_of(made_marked_tile(1));
  const auto view = gltf["images"][0]["bufferView"].get<std::size_t>();
  const std::string offset = "\"byteOffset\":" + gltf["bufferViews"][view]["byteOffset"].dump();
  for (const char* bad : {"\"byteOffset\":99999999", "\"byteOffset\":18446744073709551615", "\"byteOffset\":-1"})
    EXPECT_EQ(marked_refusal_with(offset, bad), expected) << bad;
  const std::string number = "\"bufferView\":" + std::to_string(view) + ",\"extras\"";
  for (const char* bad : {"\"bufferView\":9999,\"extras\"", "\"bufferView\":-1,\"extras\"", "\"extras\""})
    EXPECT_EQ(marked_refusal_with(number, bad), expected) << bad;
  EXPECT_EQ(marked_refusal_with("\"buffers\":[{", "\"buffers\":[{\"uri\":\"x\","),
            "tile.glb: expected a buffer inside the file");
  EXPECT_EQ(marked_refusal_with("\"buffers\":[{", "\"buffers\":[{},{"), expected);
}

TEST(GlbDamage, ABufferViewReadTwiceIsRefused) {
  EXPECT_EQ(refusal_with(kExtension, "\"bufferView\":0", "\"bufferView\":5"),
            "tile.glb: expected each byte of the buffer to be used once");
}

}  // namespace
}  // namespace citykiln::exporters

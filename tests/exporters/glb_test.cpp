#include "exporters/glb.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "tests/exporters/made_tile.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using Bytes = std::vector<std::byte>;

constexpr Instancing kBoth[] = {Instancing::kExtension, Instancing::kNodes};

scene::Header header() {
  scene::Header h;
  h.origin = {7.25, 43.5}, h.attributions = {"© OpenStreetMap contributors", "hills"};
  return h;
}
Bytes encoded(const BakedTile& tile, Instancing instancing) { return encode_glb(tile, header(), instancing); }
Result<BakedTile> decoded(const Bytes& bytes) { return decode_glb(bytes, "tile.glb"); }
std::string refusal(const Result<BakedTile>& result) { return result ? "accepted" : to_string(result.error()); }

void put_number(Bytes& bytes, std::size_t at, std::size_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::byte>(value >> 8 * i);
}
std::string json_of(const Bytes& bytes) {
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, 4);
  return {reinterpret_cast<const char*>(bytes.data()) + 20, size};
}

// The file with another JSON chunk, padded, and lengths that fit.
Bytes with_json(const Bytes& bytes, std::string json) {
  const auto buffer = std::span(bytes).subspan(20 + json_of(bytes).size());
  json.resize((json.size() + 3) / 4 * 4, ' ');
  Bytes changed(20 + json.size() + buffer.size());
  std::copy_n(bytes.begin(), 20, changed.begin());
  std::memcpy(changed.data() + 20, json.data(), json.size());
  std::copy(buffer.begin(), buffer.end(), changed.end() - static_cast<std::ptrdiff_t>(buffer.size()));
  put_number(changed, 8, changed.size()), put_number(changed, 12, json.size());
  return changed;
}

// What the reader says of a tile in whose JSON a text, which must be there, is another.
std::string refusal_with(Instancing instancing, const std::string& text, const std::string& other) {
  const Bytes bytes = encoded(made_tile(1), instancing);
  std::string json = json_of(bytes);
  const auto at = json.find(text);
  EXPECT_NE(at, std::string::npos) << text << " in " << json;
  if (at == std::string::npos) return "";
  return refusal(decoded(with_json(bytes, json.replace(at, text.size(), other))));
}

TEST(Glb, ReadsBackWhatItWroteEitherWayOfInstancing) {
  for (std::uint32_t seed = 0; seed < 100; ++seed)
    for (const Instancing instancing : kBoth) {
      const BakedTile tile = made_tile(seed);
      const auto back = decoded(encoded(tile, instancing));
      ASSERT_TRUE(back) << refusal(back);
      ASSERT_EQ(*back, tile);
    }
}

TEST(Glb, BothWaysOfInstancingAreOneTile) {
  const auto with_extension = decoded(encoded(made_tile(1), Instancing::kExtension)),
             with_nodes = decoded(encoded(made_tile(1), Instancing::kNodes));
  ASSERT_TRUE(with_extension && with_nodes);
  EXPECT_EQ(*with_extension, *with_nodes);
}

TEST(Glb, SameTileSameBytes) {
  for (const Instancing instancing : kBoth)
    EXPECT_EQ(encoded(made_tile(1), instancing), encoded(made_tile(1), instancing));
}

TEST(Glb, TheOriginIsNotRoundedToSinglePrecision) {
  BakedTile tile = made_tile(1);
  tile.origin = {16777217, -16777219, 4097};
  const auto back = decoded(encoded(tile, Instancing::kExtension));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(back->origin, tile.origin);
}

TEST(Glb, MoreCornersThan16BitsCount) {
  std::mt19937 dice(1);
  BakedTile tile = made_tile(1);
  for (const std::uint32_t corners : {65533u, 65534u, 65535u, 65538u}) {
    tile.primitives = {made_primitive(dice, materials::Material::kRock, corners, 4)};
    const auto back = decoded(encoded(tile, Instancing::kExtension));
    ASSERT_TRUE(back) << refusal(back);
    EXPECT_EQ(*back, tile) << corners;
  }
}

TEST(Glb, ATileWithoutGroundOrInstancesIsWhole) {
  BakedTile bare = made_tile(1), trees = made_tile(1);
  bare.instanced.clear(), trees.primitives.clear();
  for (const BakedTile& tile : {bare, trees}) {
    const auto back = decoded(encoded(tile, Instancing::kNodes));
    ASSERT_TRUE(back) << refusal(back);
    EXPECT_EQ(*back, tile);
  }
}

TEST(GlbDamage, EveryTruncationIsRefused) {
  const Bytes bytes = encoded(made_tile(2), Instancing::kExtension);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(decoded(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)))) << size;
}

// Tiles have no checksum, so a changed byte may make another tile: one that can be written and read.
TEST(GlbDamage, AChangedByteIsRefusedOrMakesAnotherTile) {
  std::mt19937 dice(4);
  for (const Instancing instancing : kBoth) {
    const Bytes bytes = encoded(made_tile(3), instancing);
    for (std::size_t at = 0; at < bytes.size(); at += 1 + dice() % 5) {
      Bytes changed = bytes;
      changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
      const auto tile = decoded(changed);
      if (!tile) continue;
      for (const bake::Primitive& p : tile->primitives)
        for (const auto& triangle : p.triangles)
          for (const auto corner : triangle) ASSERT_LT(corner, p.positions.size()) << "byte " << at;
      const auto again = decoded(encoded(*tile, Instancing::kExtension));
      ASSERT_TRUE(again) << "byte " << at << ": " << refusal(again);
      ASSERT_EQ(*again, *tile) << "byte " << at;
    }
  }
}

TEST(GlbDamage, ABufferLongerThanTheFileIsRefused) {
  Bytes bytes = encoded(made_tile(1), Instancing::kExtension);
  const std::size_t at = 20 + json_of(bytes).size();
  put_number(bytes, at, bytes.size() - at - 4);
  EXPECT_EQ(refusal(decoded(bytes)), "tile.glb: expected two chunks, JSON and its buffer, that fill the file");
}

TEST(GlbDamage, JsonNestedWithoutEndIsRefused) {
  const Bytes bytes = encoded(made_tile(1), Instancing::kExtension);
  const std::string deep = std::string(500000, '['), end(500000, ']');
  EXPECT_EQ(refusal(decoded(with_json(bytes, "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep + end + "}"))),
            "tile.glb: expected JSON that is not nested deeper than glTF ever is");
  const std::string text = R"({"asset":{"version":"2.0"},"extras":"\")" + deep + "\"}";
  EXPECT_EQ(refusal(decoded(with_json(bytes, text))), "tile.glb: expected a node for the tile, and one buffer");
}

TEST(GlbDamage, OtherFilesAreNotOpened) {
  const std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"/etc/hostname"}]})";
  EXPECT_NE(refusal(decoded(with_json(encoded(made_tile(1), Instancing::kExtension), json))).find("FS callback"),
            std::string::npos);
}

TEST(GlbDamage, ANodeWithoutMeshIsRefused) {
  const std::string expected = "tile.glb: expected each mesh for one kind of thing, in order";
  EXPECT_EQ(refusal_with(Instancing::kNodes, "\"mesh\":1", "\"mess\":1"), expected);
  EXPECT_EQ(refusal_with(Instancing::kNodes, "\"mesh\":1", "\"mesh\":0"), expected);
  EXPECT_EQ(refusal_with(Instancing::kExtension, "\"mesh\":2", "\"mesh\":1"), expected);
}

TEST(GlbDamage, NumbersBeyondTheirTypeAreRefused) {
  EXPECT_EQ(refusal_with(Instancing::kExtension, "\"tile\":[-3", "\"tile\":[-3e30"),
            "tile.glb: expected a whole number");
  EXPECT_EQ(refusal_with(Instancing::kNodes, "\"translation\":[0.25", "\"translation\":[1e300"),
            "tile.glb: expected places in single precision");
}

TEST(GlbDamage, ABufferViewReadTwiceIsRefused) {
  EXPECT_EQ(refusal_with(Instancing::kExtension, "\"bufferView\":0", "\"bufferView\":5"),
            "tile.glb: expected each byte of the buffer to be used once");
}

}  // namespace
}  // namespace citykiln::exporters

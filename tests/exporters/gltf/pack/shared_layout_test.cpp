#include "exporters/gltf/pack/shared_layout.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "exporters/file.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/write/encode_tile.h"
#include "tests/exporters/made_tile.h"

namespace citykiln::exporters {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

constexpr Compression kNoneAndCompressions[] = {Compression::kNone, Compression::kQuantize, Compression::kDraco,
                                                Compression::kMeshopt};

EncodedTile tile_for_three(const bake::BakedTile& tile, Compression compression, Layout layout = Layout::kShared) {
  return encode_tile(tile, {}, {.target = Target::kThree, .compression = compression}, 1, layout);
}

// A folder that goes with the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("citykiln_shared_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path / "shared"); }
  ~Folder() { fs::remove_all(path); }
  std::string write(const EncodedTile& tile) const {
    for (const SharedFile& file : tile.shared) EXPECT_TRUE(write_file((path / file.name).string(), file.bytes));
    EXPECT_TRUE(write_file((path / "tile.glb").string(), tile.glb));
    return (path / "tile.glb").string();
  }
};

TEST(SharedLayout, ReadsTheTileThatWasDivided) {
  for (const Compression compression : kNoneAndCompressions)
    for (std::uint32_t seed = 0; seed < 4; ++seed)
      for (const bake::BakedTile& tile : {made_tile(seed), made_facade_tile(seed), made_textured_tile(seed)}) {
        const Folder folder;
        const Bytes whole = tile_for_three(tile, compression, Layout::kEmbedded).glb;
        const EncodedTile divided = tile_for_three(tile, compression);
        EXPECT_FALSE(divided.shared.empty());
        EXPECT_LT(divided.glb.size(), whole.size() + 4096);
        const auto back = read_glb(folder.write(divided)), expected = decode_glb(whole, "tile.glb");
        ASSERT_TRUE(back) << to_string(back.error());
        EXPECT_EQ(*back, *expected);
      }
}

TEST(SharedLayout, TilesWithOnePrototypeReferToOneFile) {
  bake::BakedTile other = made_tile(1);
  other.tile = {7, -3}, other.primitives.pop_back();
  other.instanced[0].translations[0][0] += 1;
  const EncodedTile a = tile_for_three(made_tile(1), Compression::kNone), b = tile_for_three(other, Compression::kNone);
  ASSERT_FALSE(a.shared.empty());
  ASSERT_EQ(a.shared.size(), b.shared.size());
  for (std::size_t i = 0; i < a.shared.size(); ++i) EXPECT_EQ(a.shared[i].name, b.shared[i].name);
}

// The plants of one place are a mesh that no other tile has.
TEST(SharedLayout, StandsStayInTheirTile) {
  for (const Compression compression : kNoneAndCompressions) {
    const Folder folder;
    bake::BakedTile tile = made_tile(1);
    const std::size_t files = tile_for_three(tile, compression).shared.size();
    tile.instanced[0].name = "stand_of_oak_1";
    const EncodedTile divided = tile_for_three(tile, compression);
    EXPECT_EQ(divided.shared.size(), files - 1);
    const auto back = read_glb(folder.write(divided));
    ASSERT_TRUE(back) << to_string(back.error());
    EXPECT_EQ(back->instanced[0].name, "stand_of_oak_1");
  }
}

TEST(SharedLayout, OnlyPlainNamesInTheFolderAreRead) {
  EXPECT_TRUE(is_shared_uri("shared/0123456789abcdef_12.bin"));
  for (const char* uri :
       {"", "shared", "shared/", "shared/../a.bin", "shared/..", "../shared/a.bin", "/etc/passwd", "shared//etc/passwd",
        "file:///etc/passwd", "http://host/a.bin", "shared/a/b.bin", "shared/.hidden", "shared/a%2f..%2fb", "a.bin",
        "data:application/octet-stream;base64,AAAA", "shared\\a.bin", "Shared/a.bin"})
    EXPECT_FALSE(is_shared_uri(uri)) << uri;
}

// The error of reading a tile whose first external buffer has another URI.
std::string refusal_of(const Folder& folder, const std::string& uri) {
  EncodedTile divided = tile_for_three(made_tile(1), Compression::kNone);
  GlbParts parts = split_glb(divided.glb);
  parts.gltf["buffers"][1]["uri"] = uri;
  divided.glb = join_glb(std::move(parts));
  const auto tile = read_glb(folder.write(divided));
  return tile ? "accepted" : to_string(tile.error());
}

TEST(SharedLayout, OtherFilesAreRefusedInOneLine) {
  const Folder folder;
  ASSERT_TRUE(write_file((folder.path / "secret.bin").string(), Bytes(64)));
  fs::create_symlink(folder.path / "secret.bin", folder.path / "shared" / "link.bin");
  for (const char* uri : {"../secret.bin", "secret.bin", "/etc/passwd", "http://a/b.bin", "shared/missing.bin",
                          "shared/link.bin", "shared/../secret.bin"}) {
    const std::string error = refusal_of(folder, uri);
    EXPECT_NE(error.find("refers to"), std::string::npos) << uri << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(SharedLayout, ACutFileIsRefused) {
  const Folder folder;
  const EncodedTile divided = tile_for_three(made_tile(1), Compression::kNone);
  const std::string path = folder.write(divided);
  ASSERT_TRUE(write_file((folder.path / divided.shared[0].name).string(), Bytes(divided.shared[0].bytes.size() - 1)));
  EXPECT_FALSE(read_glb(path));
}

}  // namespace
}  // namespace citykiln::exporters

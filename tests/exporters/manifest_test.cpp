#include "exporters/manifest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "exporters/manifest_generated.h"
#include "tests/exporters/made_scene.h"

namespace citykiln::exporters {
namespace {

using Bytes = std::vector<std::byte>;
constexpr std::size_t kPreamble = 24;

scene::Scene made(std::uint64_t seed) { return SceneMaker(seed).scene(); }
Result<scene::Scene> decoded(const Bytes& bytes, std::vector<scene::TileKey> only = {}) {
  return decode_manifest(bytes, "town.kiln", only);
}

std::uint64_t number_at(const Bytes& bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 8; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}
void put_number(Bytes& bytes, std::size_t at, std::uint64_t value) {
  for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<std::byte>(value >> 8 * i);
}

// The manifest with its header changed, and the checksum that such a header would have.
Bytes with_header(const Bytes& bytes, void (*change)(fbs::HeaderT&)) {
  const std::size_t size = number_at(bytes, 8);
  fbs::HeaderT header;
  flatbuffers::GetRoot<fbs::Header>(bytes.data() + kPreamble)->UnPackTo(&header);
  change(header);
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(fbs::Header::Pack(builder, &header));
  const auto packed = std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize()));
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::byte b : packed) hash = (hash ^ static_cast<std::uint8_t>(b)) * 0x100000001b3u;
  const std::span<const std::byte> chunks = std::span(bytes).subspan(kPreamble + size);
  Bytes changed(kPreamble + packed.size() + chunks.size());
  std::copy_n(bytes.begin(), kPreamble, changed.begin());
  std::copy(packed.begin(), packed.end(), changed.begin() + kPreamble);
  std::copy(chunks.begin(), chunks.end(), changed.end() - static_cast<std::ptrdiff_t>(chunks.size()));
  put_number(changed, 8, packed.size()), put_number(changed, 16, hash);
  return changed;
}

std::string refusal(const Result<scene::Scene>& result) { return result ? "accepted" : to_string(result.error()); }

TEST(Manifest, ReadsBackWhatItWrote) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const scene::Scene scene = made(seed);
    const auto back = decoded(encode_manifest(scene, 1));
    ASSERT_TRUE(back) << seed << ": " << refusal(back);
    ASSERT_EQ(*back, scene) << seed;
  }
}

// Found by fuzz_manifest: C's strings end at a zero byte, a scene's do not.
TEST(Manifest, TextsWithZeroBytesAreKept) {
  scene::Scene scene = made(1);
  const std::string text("a\0b", 3);
  scene.header.sky.time = text, scene.header.sources = {text}, scene.header.attributions = {text, ""};
  const auto back = decoded(encode_manifest(scene, 1));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(*back, scene);
}

TEST(Manifest, SameSceneSameBytesWithAnyThreads) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Bytes bytes = encode_manifest(made(seed), 1);
    EXPECT_EQ(bytes, encode_manifest(made(seed), 1));
    EXPECT_EQ(bytes, encode_manifest(made(seed), 7));
  }
}

TEST(Manifest, ReadsOneTileWithoutTheRest) {
  const scene::Scene scene = made(1);
  const auto back = decoded(encode_manifest(scene, 1), {{0, 0}});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->header, scene.header);
  ASSERT_EQ(back->chunks.size(), 1u);
  EXPECT_EQ(back->chunks[0], scene.chunks[1]);
  EXPECT_EQ(refusal(decoded(encode_manifest(scene, 1), {{5, 6}})), "town.kiln: has no tile 5_6");
}

TEST(Manifest, ASceneWithoutTilesIsWhole) {
  const scene::Scene scene{made(1).header, {}};
  const auto back = decoded(encode_manifest(scene, 1));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(*back, scene);
}

TEST(Manifest, EveryTruncationIsRefused) {
  const Bytes bytes = encode_manifest(made(2), 1);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(decoded(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)))) << size;
}

TEST(Manifest, BytesBehindTheLastChunkAreRefused) {
  Bytes bytes = encode_manifest(made(2), 1);
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(decoded(bytes));
}

TEST(Manifest, NoChangedByteIsReadAsAnotherScene) {
  const scene::Scene scene = made(3);
  const Bytes bytes = encode_manifest(scene, 1);
  std::mt19937_64 dice(3);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    Bytes changed = bytes;
    changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
    const auto back = decoded(changed);
    ASSERT_TRUE(!back || *back == scene) << "byte " << at;
  }
}

// The hash of no bytes is right, so the reader goes on. Found by fuzz_manifest.
TEST(Manifest, AnEmptyHeaderIsRefused) {
  Bytes bytes = encode_manifest(made(4), 1);
  put_number(bytes, 8, 0), put_number(bytes, 16, 0xcbf29ce484222325u);
  EXPECT_EQ(refusal(decoded(bytes)), "town.kiln: expected a citykiln manifest, found one whose header is damaged");
}

TEST(Manifest, AnotherFormatIsOneClearLine) {
  const Bytes newer = with_header(encode_manifest(made(4), 1), [](fbs::HeaderT& h) { h.format_major = 9; });
  EXPECT_EQ(refusal(decoded(newer)), "town.kiln: expected format 1, found 9: made by another citykiln");
  const Bytes other = with_header(encode_manifest(made(4), 1), [](fbs::HeaderT& h) { ++h.tables_hash; });
  EXPECT_EQ(refusal(decoded(other)),
            "town.kiln: expected this version's materials and surface classes, found others: made by another citykiln");
}

TEST(Manifest, ALaterMinorFormatIsRead) {
  const scene::Scene scene = made(4);
  const auto back = decoded(with_header(encode_manifest(scene, 1), [](fbs::HeaderT& h) { h.format_minor = 7; }));
  ASSERT_TRUE(back) << refusal(back);
  EXPECT_EQ(*back, scene);
}

// What is wrong with the index of a header changed so, in words.
std::string index_refusal(void (*change)(fbs::HeaderT&), std::vector<scene::TileKey> only = {}) {
  return refusal(decoded(with_header(encode_manifest(made(5), 1), change), only));
}

TEST(ManifestIndex, TilesTwiceOrUnsortedAreRefused) {
  const std::string expected = "town.kiln, tile -1_0: expected each tile once, in the order of x, then y";
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->x = -1; }), expected);
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[0]->x = 0, h.chunks[1]->x = -1; }), expected);
}

TEST(ManifestIndex, TilesOutsideTheRegionAreRefused) {
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->x = 1; }),
            "town.kiln, tile 1_0: expected tiles inside the region");
}

TEST(ManifestIndex, ChunksThatOverlapOrLeaveGapsAreRefused) {
  const std::string expected = "town.kiln, tile 0_0: expected its bytes right behind those of the tile before";
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->offset -= 1; }), expected);
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->offset += 1; }), expected);
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->size -= 1; }),
            "town.kiln: expected the end of the file behind the last tile");
}

TEST(ManifestIndex, IsCheckedAsAWholeWhenOneTileIsRead) {
  EXPECT_NE(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->x = 1; }, {{-1, 0}}), "accepted");
}

TEST(ManifestIndex, SizesBeyondBeliefAreRefused) {
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->size = ~std::uint64_t{0}; }),
            "town.kiln, tile 0_0: expected its bytes, found the end of the file");
  EXPECT_EQ(index_refusal([](fbs::HeaderT& h) { h.chunks[1]->raw_size = std::uint64_t{1} << 40; }),
            "town.kiln, tile 0_0: expected at most 268435456 bytes unpacked, found 1099511627776");
}

}  // namespace
}  // namespace citykiln::exporters

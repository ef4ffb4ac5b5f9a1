#include "exporters/kiln/manifest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "exporters/kiln/chunk_codec.h"
#include "exporters/kiln/streams.h"
#include "exporters/kiln/zstd_frame.h"
#include "exporters/manifest_generated.h"
#include "tests/exporters/made_scene.h"

namespace citykiln::exporters {
namespace {

using Bytes = std::vector<std::byte>;
using RawBytes = std::vector<std::uint8_t>;
constexpr std::size_t kPreamble = 24;

scene::Scene made_scene(std::uint64_t seed) { return SceneMaker(seed).scene(); }
Result<scene::Scene> decoded_manifest(const Bytes& bytes, std::vector<scene::TileKey> only = {}) {
  return decode_manifest(bytes, "town.kiln", only);
}

std::uint64_t number_at(const Bytes& bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}
void put_little_endian(Bytes& bytes, std::size_t at, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<std::byte>(value >> 8 * i);
}
std::uint64_t hash_of(std::span<const std::byte> bytes, std::uint64_t hash = 0xcbf29ce484222325u) {
  for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint8_t>(b)) * 0x100000001b3u;
  return hash;
}

std::span<const std::byte> header_frame(const Bytes& bytes) {
  return std::span(bytes).subspan(kPreamble, number_at(bytes, 12, 4));
}
std::span<const std::byte> body_of(const Bytes& bytes) {
  return std::span(bytes).subspan(kPreamble + header_frame(bytes).size());
}
fbs::HeaderT header_of(const Bytes& bytes) {
  fbs::HeaderT header;
  flatbuffers::GetRoot<fbs::Header>(unpacked(header_frame(bytes), nullptr, "")->data())->UnPackTo(&header);
  return header;
}

// A manifest of this frame for a header, and this body, and the checksum that it would have.
Bytes assembled(std::span<const std::byte> header, std::span<const std::byte> body) {
  Bytes bytes(kPreamble + header.size() + body.size());
  std::ranges::copy(body, std::ranges::copy(header, bytes.begin() + kPreamble).out);
  std::ranges::copy(std::as_bytes(std::span("CITYKILN")).first(8), bytes.begin());
  put_little_endian(bytes, 8, 7, 2), put_little_endian(bytes, 10, 0, 2), put_little_endian(bytes, 12, header.size(), 4);
  put_little_endian(bytes, 16, hash_of(header, hash_of(std::span(bytes).first(16))), 8);
  return bytes;
}
Bytes assembled(const fbs::HeaderT& header, std::span<const std::byte> body) {
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(fbs::Header::Pack(builder, &header));
  return assembled(packed({builder.GetBufferPointer(), builder.GetSize()}, nullptr), body);
}
Bytes with_header(const Bytes& bytes, void (*change)(fbs::HeaderT&)) {
  fbs::HeaderT header = header_of(bytes);
  change(header);
  return assembled(header, body_of(bytes));
}

// The index of a manifest of two tiles, (-1, 0) and (0, 0).
struct Index {
  std::int64_t x[2] = {-1, 0}, y[2] = {0, 0};
  std::uint64_t size[2] = {}, checksum[2] = {};
};
Index index_of(const Bytes& bytes) {
  const fbs::HeaderT header = header_of(bytes);
  StreamReader size(header.index->size);
  const std::uint64_t first = size.get();
  return {{-1, 0}, {0, 0}, {first, size.get()}, {header.index->checksum[0], header.index->checksum[1]}};
}
Bytes with_index(const Bytes& bytes, const Index& index) {
  StreamWriter x, y, size;
  for (int i = 0; i < 2; ++i) x.put_delta(index.x[i]), y.put_delta(index.y[i]), size.put(index.size[i]);
  fbs::HeaderT header = header_of(bytes);
  *header.index = {};
  header.index->x = x.bytes(), header.index->y = y.bytes(), header.index->size = size.bytes();
  header.index->checksum = {index.checksum[0], index.checksum[1]};
  return assembled(header, body_of(bytes));
}

// The manifest with another frame in the place of its second tile's.
Bytes with_second_frame(const Bytes& bytes, std::span<const std::byte> frame) {
  Index index = index_of(bytes);
  const auto first = body_of(bytes).first(index.size[0]);
  Bytes changed = bytes;
  changed.resize(bytes.size() - index.size[1]);
  changed.insert(changed.end(), frame.begin(), frame.end());
  index.size[1] = frame.size(), index.checksum[1] = hash_of(frame);
  EXPECT_TRUE(std::ranges::equal(body_of(changed).first(first.size()), first));
  return with_index(changed, index);
}

// Eight times eight tiles: so many that they share a dictionary.
scene::Scene wide(std::uint64_t seed) {
  SceneMaker maker(seed);
  scene::Scene scene = maker.scene();
  scene.header.extent = {{0, 0}, {8 * 128, 8 * 128}};
  scene.chunks.clear();
  for (std::int32_t x = 0; x < 8; ++x)
    for (std::int32_t y = 0; y < 8; ++y) scene.chunks.push_back(maker.chunk({x, y}, 0x1p-7));
  return scene;
}

std::string manifest_refusal(const Result<scene::Scene>& result) {
  return result ? "accepted" : to_string(result.error());
}

TEST(StreamSizes, SumUpTheStreamsOfAllChunks) {
  const scene::Scene scene = made_scene(3);
  std::map<std::string, std::uint64_t> expected;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const auto& [name, bytes] : encode_chunk(chunk, scene.header.seed)) expected[name] += bytes.size();
  std::map<std::string, std::uint64_t> found;
  for (const StreamSize& size : stream_sizes_of(scene)) {
    found[size.name] = size.raw_bytes;
    EXPECT_GT(size.packed_bytes, 0u) << size.name;
  }
  EXPECT_EQ(found, expected);
}

TEST(Manifest, ReadsBackWhatItWrote) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const scene::Scene scene = made_scene(seed);
    const auto back = decoded_manifest(encode_manifest(scene, 1));
    ASSERT_TRUE(back) << seed << ": " << manifest_refusal(back);
    ASSERT_EQ(*back, scene) << seed;
  }
}

TEST(Manifest, KeepsTheClimateAndRefusesOneThatIsNone) {
  scene::Scene scene = made_scene(2);
  climate::ClimateField& field = scene.header.climate;
  field = climate::uniform_climate(climate::ClimateClass::kBWh);
  field.first_column = -3, field.first_row = 5, field.columns = 2;
  field.nodes.push_back({{climate::ClimateClass::kAf, climate::ClimateClass::kET}, {200, 55}});
  const auto back = decoded_manifest(encode_manifest(scene, 1));
  ASSERT_TRUE(back) << manifest_refusal(back);
  EXPECT_EQ(back->header.climate, field);
  field.nodes[1].shares[1] = 54;
  EXPECT_EQ(manifest_refusal(decoded_manifest(encode_manifest(scene, 1))),
            "town.kiln: expected a citykiln manifest, found one whose header is damaged");
}

// Found by fuzz_manifest: C's strings end at a zero byte, a scene's do not.
TEST(Manifest, TextsWithZeroBytesAreKept) {
  scene::Scene scene = made_scene(1);
  const std::string text("a\0b", 3);
  scene.header.sources = {text}, scene.header.attributions = {text, ""};
  const auto back = decoded_manifest(encode_manifest(scene, 1));
  ASSERT_TRUE(back) << manifest_refusal(back);
  EXPECT_EQ(*back, scene);
}

TEST(Manifest, HasATimeOrNoneAndRefusesOtherTexts) {
  const Bytes bytes = encode_manifest(made_scene(1), 1);
  const auto without = decoded_manifest(with_header(bytes, [](fbs::HeaderT& h) { h.sky->time.clear(); }));
  ASSERT_TRUE(without) << manifest_refusal(without);
  EXPECT_FALSE(without->header.sky.time);
  EXPECT_EQ(manifest_refusal(decoded_manifest(with_header(bytes, [](fbs::HeaderT& h) { h.sky->time = "noon"; }))),
            "town.kiln: expected a citykiln manifest, found one whose header is damaged");
}

TEST(Manifest, SameSceneSameBytesWithAnyThreads) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Bytes bytes = encode_manifest(made_scene(seed), 1);
    EXPECT_EQ(bytes, encode_manifest(made_scene(seed), 1));
    EXPECT_EQ(bytes, encode_manifest(made_scene(seed), 7));
  }
  EXPECT_EQ(encode_manifest(wide(1), 1), encode_manifest(wide(1), 7));
}

TEST(Manifest, ReadsOneTileWithoutTheRest) {
  const scene::Scene scene = made_scene(1);
  const auto back = decoded_manifest(encode_manifest(scene, 1), {{0, 0}});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->header, scene.header);
  ASSERT_EQ(back->chunks.size(), 1u);
  EXPECT_EQ(back->chunks[0], scene.chunks[1]);
  EXPECT_EQ(manifest_refusal(decoded_manifest(encode_manifest(scene, 1), {{5, 6}})), "town.kiln: has no tile 5_6");
}

TEST(Manifest, ASceneWithoutTilesIsWhole) {
  const scene::Scene scene{made_scene(1).header, {}};
  const auto back = decoded_manifest(encode_manifest(scene, 1));
  ASSERT_TRUE(back) << manifest_refusal(back);
  EXPECT_EQ(*back, scene);
}

TEST(Manifest, EveryTruncationIsRefused) {
  const Bytes bytes = encode_manifest(made_scene(2), 1);
  ASSERT_FALSE(bytes.empty());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    ASSERT_FALSE(decoded_manifest(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)))) << size;
}

TEST(Manifest, BytesBehindTheLastChunkAreRefused) {
  Bytes bytes = encode_manifest(made_scene(2), 1);
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(decoded_manifest(bytes));
}

TEST(Manifest, NoChangedByteIsReadAsAnotherScene) {
  const scene::Scene scene = made_scene(3);
  const Bytes bytes = encode_manifest(scene, 1);
  std::mt19937_64 dice(3);
  ASSERT_FALSE(bytes.empty());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    Bytes changed = bytes;
    changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
    const auto back = decoded_manifest(changed);
    ASSERT_TRUE(!back || *back == scene) << "byte " << at;
  }
}

// Found by fuzz_manifest, when an empty header's hash was right.
TEST(Manifest, AnEmptyHeaderIsRefused) {
  const Bytes none, bytes = encode_manifest(made_scene(4), 1);
  EXPECT_EQ(manifest_refusal(decoded_manifest(assembled(none, body_of(bytes)))),
            "town.kiln, header: expected a zstd frame that states its size");
  EXPECT_EQ(manifest_refusal(decoded_manifest(assembled(packed({}, nullptr), body_of(bytes)))),
            "town.kiln: expected a citykiln manifest, found one whose header is damaged");
}

// The line says which program made the manifest, where that can still be read, and what to do.
TEST(Manifest, AnotherFormatIsOneClearLineWhateverElseIsThere) {
  Bytes newer = encode_manifest(made_scene(4), 1);
  put_little_endian(newer, 8, 9, 2);
  EXPECT_EQ(manifest_refusal(decoded_manifest(newer)),
            "town.kiln: has manifest format 9, expected 7: made by citykiln 0.1.0, and this is 0.1.0; compile the map "
            "again (citykiln compile MAP -o OUT), or bake it with that version");
  std::fill(newer.begin() + 12, newer.end(), std::byte{0xff});
  EXPECT_EQ(manifest_refusal(decoded_manifest(newer)),
            "town.kiln: has manifest format 9, expected 7: made by citykiln, and this is 0.1.0; compile the map again "
            "(citykiln compile MAP -o OUT), or bake it with that version");
}

TEST(Manifest, OtherTablesAreOneClearLine) {
  const Bytes other = with_header(encode_manifest(made_scene(4), 1), [](fbs::HeaderT& h) {
    ++h.tables_hash;
    h.generator_version = "0.0.9";
  });
  EXPECT_EQ(manifest_refusal(decoded_manifest(other)),
            "town.kiln: has other materials, classes or species than this program: made by citykiln 0.0.9, and this is "
            "0.1.0; compile the map again (citykiln compile MAP -o OUT), or bake it with that version");
}

TEST(Manifest, AHeaderWithoutASnowLineHasNone) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const scene::Scene scene = made_scene(seed);
    const auto back =
        decoded_manifest(with_header(encode_manifest(scene, 1), [](fbs::HeaderT& h) { h.snow_line_m = NAN; }));
    ASSERT_TRUE(back) << manifest_refusal(back);
    EXPECT_FALSE(back->header.snow_line_m);
  }
}

TEST(Manifest, ASnowLineBeyondAllHeightsIsDamage) {
  const Bytes endless =
      with_header(encode_manifest(made_scene(4), 1), [](fbs::HeaderT& h) { h.snow_line_m = INFINITY; });
  EXPECT_EQ(manifest_refusal(decoded_manifest(endless)),
            "town.kiln: expected a citykiln manifest, found one whose header is damaged");
}

TEST(Manifest, ValuesOfLayersAndLightsThatAreNoneAreDamage) {
  const Bytes bytes = encode_manifest(made_scene(4), 1);
  for (void (*change)(fbs::HeaderT&) :
       {+[](fbs::HeaderT& h) { h.wood_density = 4097; }, +[](fbs::HeaderT& h) { h.lamps = 3; },
        +[](fbs::HeaderT& h) { h.lit_windows = 1025; }, +[](fbs::HeaderT& h) { h.people = 1025; }})
    EXPECT_EQ(manifest_refusal(decoded_manifest(with_header(bytes, change))),
              "town.kiln: expected a citykiln manifest, found one whose header is damaged");
}

fbs::ClipRingT ring_of(bool is_hole, std::vector<std::int32_t> x, std::vector<std::int32_t> y) {
  fbs::ClipRingT ring;
  ring.is_hole = is_hole, ring.x = std::move(x), ring.y = std::move(y);
  return ring;
}

TEST(Manifest, RingsOfAClipThatAreNoneAreDamage) {
  const Bytes bytes = encode_manifest(made_scene(4), 1);
  for (const fbs::ClipRingT& ring :
       {ring_of(true, {0, 1, 0}, {0, 0, 1}), ring_of(false, {0, 1}, {0, 0}), ring_of(false, {0, 1, 0}, {0, 0})}) {
    fbs::HeaderT header = header_of(bytes);
    header.clip.clear();
    header.clip.push_back(std::make_unique<fbs::ClipRingT>(ring));
    EXPECT_EQ(manifest_refusal(decoded_manifest(assembled(header, body_of(bytes)))),
              "town.kiln: expected a citykiln manifest, found one whose header is damaged");
  }
}

TEST(Manifest, ALaterMinorFormatIsRead) {
  const scene::Scene scene = made_scene(4);
  Bytes later = encode_manifest(scene, 1);
  put_little_endian(later, 10, 7, 2);
  put_little_endian(later, 16, hash_of(header_frame(later), hash_of(std::span(later).first(16))), 8);
  const auto back = decoded_manifest(later);
  ASSERT_TRUE(back) << manifest_refusal(back);
  EXPECT_EQ(*back, scene);
}

// One text, referred to a thousand times: a header of a few kB would unpack to a thousand times that.
TEST(Manifest, TextsTakeNoMoreThanTheirHeader) {
  const Bytes bytes = encode_manifest(made_scene(4), 1);
  const fbs::HeaderT header = header_of(bytes);
  flatbuffers::FlatBufferBuilder builder;
  const auto text = builder.CreateString(std::string(4096, 'a'));
  const std::vector<flatbuffers::Offset<flatbuffers::String>> texts(1000, text);
  const auto named = builder.CreateVector(texts);
  const auto sky = fbs::Sky::Pack(builder, header.sky.get());
  const auto extent = builder.CreateVector(header.region_m);
  const auto index = fbs::Index::Pack(builder, header.index.get());
  builder.Finish(
      fbs::CreateHeader(builder, 0, header.tables_hash, 7, 43, extent, header.tile_m, 0, 0, sky, named, 0, 0, index));
  const Bytes frame = packed({builder.GetBufferPointer(), builder.GetSize()}, nullptr);
  EXPECT_EQ(manifest_refusal(decoded_manifest(assembled(frame, body_of(bytes)))),
            "town.kiln: expected a citykiln manifest, found one whose header is damaged");
}

// The error for a manifest with a changed index.
std::string index_refusal(void (*change)(Index&), std::vector<scene::TileKey> only = {}) {
  const Bytes bytes = encode_manifest(made_scene(5), 1);
  Index index = index_of(bytes);
  change(index);
  return manifest_refusal(decoded_manifest(with_index(bytes, index), only));
}

TEST(ManifestIndex, IsReadAsItIsWritten) {
  EXPECT_EQ(index_refusal([](Index&) {}), "accepted");
}

TEST(ManifestIndex, TilesTwiceOrUnsortedAreRefused) {
  const std::string expected = "town.kiln, tile -1_0: expected each tile once, in the order of x, then y";
  EXPECT_EQ(index_refusal([](Index& i) { i.x[1] = -1; }), expected);
  EXPECT_EQ(index_refusal([](Index& i) { i.x[0] = 0, i.x[1] = -1; }), expected);
}

TEST(ManifestIndex, TilesOutsideTheRegionAreRefused) {
  EXPECT_EQ(index_refusal([](Index& i) { i.x[1] = 1; }), "town.kiln, tile 1_0: expected tiles inside the region");
}

TEST(ManifestIndex, TilesBeyondTheirTypeAreRefused) {
  const std::string expected = "town.kiln: expected a citykiln manifest, found one whose header is damaged";
  EXPECT_EQ(index_refusal([](Index& i) { i.x[1] = std::int64_t{1} << 32; }), expected);
  EXPECT_EQ(index_refusal([](Index& i) { i.y[1] = -(std::int64_t{1} << 32); }), expected);
}

TEST(ManifestIndex, SizesThatDoNotAddUpAreRefused) {
  const std::string damaged = "expected the checksum that the header states, found another: the file is damaged";
  EXPECT_EQ(index_refusal([](Index& i) { --i.size[0], ++i.size[1]; }), "town.kiln, tile -1_0: " + damaged);
  EXPECT_EQ(index_refusal([](Index& i) { --i.size[1]; }),
            "town.kiln: expected the end of the file behind the last tile");
}

TEST(ManifestIndex, StreamsThatEndEarlyOrLateAreRefused) {
  const Bytes bytes = encode_manifest(made_scene(5), 1);
  for (auto stream : {&fbs::IndexT::x, &fbs::IndexT::y, &fbs::IndexT::size}) {
    for (const bool is_late : {false, true}) {
      fbs::HeaderT header = header_of(bytes);
      auto& numbers = (*header.index).*stream;
      is_late ? numbers.push_back(0) : numbers.pop_back();
      EXPECT_EQ(manifest_refusal(decoded_manifest(assembled(header, body_of(bytes)))),
                "town.kiln: expected a citykiln manifest, found one whose header is damaged");
    }
  }
  EXPECT_FALSE(decoded_manifest(with_header(bytes, [](fbs::HeaderT& h) { h.index->checksum.pop_back(); })));
  EXPECT_FALSE(decoded_manifest(with_header(bytes, [](fbs::HeaderT& h) { h.index->checksum.clear(); })));
  EXPECT_FALSE(decoded_manifest(with_header(bytes, [](fbs::HeaderT& h) { h.index = nullptr; })));
}

TEST(ManifestIndex, IsCheckedAsAWholeWhenOneTileIsRead) {
  EXPECT_NE(index_refusal([](Index& i) { i.x[1] = 1; }, {{-1, 0}}), "accepted");
}

TEST(ManifestIndex, SizesBeyondBeliefAreRefused) {
  EXPECT_EQ(index_refusal([](Index& i) { i.size[1] = ~std::uint64_t{0}; }),
            "town.kiln, tile 0_0: expected its bytes, found the end of the file");
}

// The error for a manifest whose second tile holds these bytes.
std::string chunk_refusal(const RawBytes& raw) {
  return manifest_refusal(decoded_manifest(with_second_frame(encode_manifest(made_scene(5), 1), packed(raw, nullptr))));
}

TEST(ManifestChunk, StreamsThatDoNotAddUpAreRefused) {
  const Bytes bytes = encode_manifest(made_scene(5), 1);
  const RawBytes whole = *unpacked(body_of(bytes).subspan(index_of(bytes).size[0]), nullptr, "");
  EXPECT_EQ(chunk_refusal(whole), "accepted");
  const std::string expected =
      "town.kiln, tile 0_0: expected as many streams as this format has, each of its stated size";
  RawBytes longer = whole, shorter = whole;
  longer.push_back(0), shorter.pop_back();
  EXPECT_EQ(chunk_refusal(longer), expected);
  EXPECT_EQ(chunk_refusal(shorter), expected);
  EXPECT_EQ(chunk_refusal({}), expected);
  EXPECT_EQ(chunk_refusal(RawBytes(stream_names().size() - 1)), expected);
  EXPECT_EQ(chunk_refusal(RawBytes(stream_names().size() * 10, 0xff)), expected);
  EXPECT_EQ(chunk_refusal(RawBytes(stream_names().size())),
            "town.kiln, tile 0_0: expected sound values in \"point step\"");
}

TEST(ManifestChunk, FramesThatAreNoneAreRefused) {
  const Bytes text(100, std::byte{'a'}), bytes = encode_manifest(made_scene(5), 1);
  EXPECT_EQ(manifest_refusal(decoded_manifest(with_second_frame(bytes, text))),
            "town.kiln, tile 0_0: expected a zstd frame that states its size");
}

TEST(ManifestDictionary, IsSharedByManyTiles) {
  const scene::Scene scene = wide(6);
  const Bytes bytes = encode_manifest(scene, 1);
  EXPECT_FALSE(header_of(bytes).dictionary.empty());
  const auto back = decoded_manifest(bytes);
  ASSERT_TRUE(back) << manifest_refusal(back);
  EXPECT_EQ(*back, scene);
  const auto alone = decoded_manifest(bytes, {{3, 5}});
  ASSERT_TRUE(alone) << manifest_refusal(alone);
  EXPECT_EQ(alone->chunks, std::vector{scene.chunks[3 * 8 + 5]});
}

TEST(ManifestDictionary, IsNotThereForAFewTiles) {
  EXPECT_TRUE(header_of(encode_manifest(made_scene(6), 1)).dictionary.empty());
}

TEST(ManifestDictionary, ABrokenOneIsOneClearLine) {
  const Bytes bytes = encode_manifest(wide(6), 1);
  const std::string expected = "town.kiln: expected a zstd dictionary in the header, found damage in it";
  for (const RawBytes& broken : {RawBytes{0}, RawBytes(500, 'a'), RawBytes{0x37, 0xa4, 0x30, 0xec, 1, 0, 0, 0}}) {
    fbs::HeaderT header = header_of(bytes);
    header.dictionary = broken;
    EXPECT_EQ(manifest_refusal(decoded_manifest(assembled(header, body_of(bytes)), {{3, 5}})), expected);
  }
  // its tables of entropies
  fbs::HeaderT header = header_of(bytes);
  std::fill(header.dictionary.begin() + 8, header.dictionary.end(), std::uint8_t{0xff});
  EXPECT_EQ(manifest_refusal(decoded_manifest(assembled(header, body_of(bytes)))), expected);
}

TEST(ManifestDictionary, AMissingOneIsNoticed) {
  const Bytes bytes = with_header(encode_manifest(wide(6), 1), [](fbs::HeaderT& h) { h.dictionary.clear(); });
  EXPECT_EQ(manifest_refusal(decoded_manifest(bytes)),
            "town.kiln, tile 0_0: expected a zstd frame, found damage in it");
}

}  // namespace
}  // namespace citykiln::exporters

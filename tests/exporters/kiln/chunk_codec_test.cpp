#include "exporters/kiln/chunk_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "exporters/kiln/streams.h"
#include "tests/exporters/made_scene.h"

namespace citykiln::exporters {
namespace {

constexpr scene::TileKey kTile{3, -4};
constexpr std::uint64_t kSeed = 5;

scene::Chunk made_chunk(std::uint64_t seed) { return SceneMaker(seed).chunk(kTile, 0x1p-10); }

roads::Road one_lane(ObjectId id, Polyline axis) {
  roads::Road road;
  road.id = id, road.axis = std::move(axis);
  road.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 3}}, 1.5};
  return road;
}

// The name of the wrong stream of a chunk; "" where none is.
std::string wrong_in(const Streams& streams) {
  std::string wrong;
  decode_chunk(streams, kTile, kSeed, wrong);
  return wrong;
}

std::vector<std::uint8_t> stream_of(std::initializer_list<std::uint64_t> numbers) {
  StreamWriter stream;
  for (const std::uint64_t n : numbers) stream.put(n);
  return stream.bytes();
}

// A chunk of nothing but flat ground.
Streams empty_streams() {
  scene::Chunk chunk;
  chunk.tile = kTile;
  chunk.heights = {{0, 0}, {64, 64}, 2, 2, {0, 0, 0, 0}, 0};
  Streams streams = encode_chunk(chunk, kSeed);
  for (const char* name : stream_names()) streams[name];
  return streams;
}

TEST(ChunkCodec, ReadsBackWhatItWrote) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const scene::Chunk chunk = made_chunk(seed);
    std::string wrong;
    const auto back = decode_chunk(encode_chunk(chunk, kSeed), kTile, kSeed, wrong);
    ASSERT_TRUE(back) << wrong;
    ASSERT_EQ(*back, chunk) << seed;
  }
}

TEST(ChunkCodec, WritesNoStreamThatTheListDoesNotName) {
  const auto names = stream_names();
  EXPECT_FALSE(encode_chunk(made_chunk(0), kSeed).empty());
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    for (const auto& [name, bytes] : encode_chunk(made_chunk(seed), kSeed))
      EXPECT_TRUE(std::find(names.begin(), names.end(), name) != names.end()) << name;
}

// Any bytes are refused, or make a chunk that can be written and read back.
TEST(ChunkCodec, WhateverItAcceptsIsAChunk) {
  std::mt19937_64 dice(1);
  int accepted = 0;
  for (int round = 0; round < 20000; ++round) {
    Streams streams = encode_chunk(made_chunk(dice() % 50), kSeed);
    const auto names = stream_names();
    auto& stream = streams[names[dice() % names.size()]];
    if (stream.empty()) continue;
    stream[dice() % stream.size()] ^= static_cast<std::uint8_t>(1 + dice() % 255);
    std::string wrong;
    const auto chunk = decode_chunk(streams, kTile, kSeed, wrong);
    ASSERT_EQ(chunk.has_value(), wrong.empty());
    if (!chunk) continue;
    ++accepted;
    const auto again = decode_chunk(encode_chunk(*chunk, kSeed), kTile, kSeed, wrong);
    ASSERT_TRUE(again) << wrong;
    ASSERT_EQ(*again, *chunk);
  }
  EXPECT_GT(accepted, 1000);
}

TEST(ChunkCodec, AStreamTooShortOrTooLongIsNamed) {
  const Streams whole = encode_chunk(made_chunk(7), kSeed);
  ASSERT_FALSE(whole.empty());
  for (const auto& [name, bytes] : whole) {
    Streams longer = whole, shorter = whole;
    longer[name].push_back(0);
    EXPECT_EQ(wrong_in(longer), name);
    if (bytes.empty()) continue;
    shorter[name].pop_back();
    EXPECT_NE(wrong_in(shorter), "") << name;
  }
}

TEST(ChunkCodec, AValueBeyondItsTypeIsNamed) {
  Streams streams = empty_streams();
  streams["lamps"] = stream_of({1}), streams["id type"] = stream_of({1}), streams["id"] = stream_of({2}),
  streams["part"] = stream_of({0}), streams["points"] = stream_of({0}), streams["x"] = stream_of({0}),
  streams["y"] = stream_of({0}), streams["lamp height"] = stream_of({0}), streams["lamp light"] = stream_of({0});
  EXPECT_EQ(wrong_in(streams), "");
  const auto with = [&](const char* name, std::uint64_t value) {
    Streams changed = streams;
    changed[name] = stream_of({value});
    return wrong_in(changed);
  };
  EXPECT_EQ(with("part", std::uint64_t{1} << 32), "part");
  EXPECT_EQ(with("id type", 5), "id type");
  EXPECT_EQ(with("point step", 2), "point step");
  EXPECT_EQ(with("points", 1), "points");
  EXPECT_EQ(with("points", 4), "points");
  EXPECT_EQ(with("x", std::uint64_t{1} << 40), "x");
  EXPECT_EQ(with("lamp height", ~std::uint64_t{0}), "lamp height");
  EXPECT_EQ(with("lamp light", 2), "lamp light");
}

TEST(ChunkCodec, AFieldOffItsGridIsNamed) {
  const auto field_at = [](std::uint64_t corner, std::uint64_t step, std::uint64_t columns, std::uint64_t size) {
    Streams streams = empty_streams();
    // steps are written as differences, twice as large for their sign; the error is as long as the corner is far
    const std::uint64_t down = 2 * (step - corner) - (step > corner ? 1 : 0);
    streams["field"] = stream_of({1, 2 * corner, 0, 2 * (step - corner), 0, columns, 2, down, size, 0});
    streams["heights"].assign(size, 0);
    return wrong_in(streams);
  };
  const auto field = [&](std::uint64_t step, std::uint64_t columns, std::uint64_t size) {
    return field_at(0, step, columns, size);
  };
  EXPECT_EQ(field(64 * 1024, 2, 4), "");
  EXPECT_EQ(field(9 * 128, 2, 4), "");
  EXPECT_EQ(field(9 * 128 + 1, 2, 4), "field");
  EXPECT_EQ(field(7 * 128, 2, 4), "field");
  EXPECT_EQ(field_at(68 * 1024, 68 * 1024, 2, 4), "");
  EXPECT_EQ(field_at(128, 68 * 1024, 2, 4), "");
  EXPECT_EQ(field_at(127, 68 * 1024, 2, 4), "field");
  EXPECT_EQ(field(64 * 1024, 1, 2), "field");
  EXPECT_EQ(field(64 * 1024, 3, 4), "field");
}

TEST(ChunkCodec, AFieldIsDividedInTwoOrFour) {
  const auto divided = [](std::uint64_t parts, std::uint64_t columns) {
    Streams streams = empty_streams();
    const std::uint64_t step = 64 * 2048, size = columns * 4;
    streams["field"] = stream_of({parts, 0, 0, step, 0, columns, 4, step - 1, size, 0});
    streams["heights"].assign(size, 0);
    return wrong_in(streams);
  };
  for (const std::uint64_t parts : {1, 2, 4}) EXPECT_EQ(divided(parts, 4), "") << parts;
  for (const std::uint64_t parts : {0, 3, 5, 8}) EXPECT_EQ(divided(parts, 4), "field") << parts;
  EXPECT_EQ(divided(1, 3), "");
  EXPECT_EQ(divided(2, 3), "field");
}

TEST(ChunkCodec, WhatNoChunkCanBeIsNamed) {
  scene::Chunk chunk;
  chunk.tile = kTile;
  chunk.heights = {{0, 0}, {64, 64}, 2, 2, {0, 0, 0, 0}, 0};
  const auto wrong_with = [&](auto change) {
    scene::Chunk changed = chunk;
    change(changed);
    return wrong_in(encode_chunk(changed, kSeed));
  };
  const ObjectId id{{OsmType::kWay, 7}, 0};
  EXPECT_EQ(wrong_with([&](auto& c) { c.roads = {one_lane(id, {{1, 2}})}; }), "road points");
  EXPECT_EQ(wrong_with([&](auto& c) { c.roads = {one_lane(id, {{1, 2}, {3, 4}})}; }), "");
  EXPECT_EQ(wrong_with([&](auto& c) {
              c.roads = {one_lane(id, {{1, 2}, {3, 4}})};
              c.roads[0].section.lanes[0].is_raised = true;
            }),
            "lanes");
  EXPECT_EQ(wrong_with([&](auto& c) {
              c.roads = {one_lane(id, {{1, 2}, {3, 4}})};
              c.roads[0].section.axis_offset_m = 4;
            }),
            "lanes");
  EXPECT_EQ(wrong_with([&](auto& c) {
              c.roads = {one_lane(id, {{1, 2}, {3, 4}})};
              c.roads[0].points = {{2, {}, 0}};
            }),
            "track vertex");
  EXPECT_EQ(wrong_with([&](auto& c) { c.surfaces = {{id, {}, 3, {}}}; }), "surface rings");
  EXPECT_EQ(wrong_with([&](auto& c) { c.woods = {{id, plants::SpeciesMix{}, 120, 12}}; }), "");
  EXPECT_EQ(wrong_with([&](auto& c) { c.woods = {{id, plants::SpeciesMix{}, 9999, 12}}; }), "wood");
  EXPECT_EQ(wrong_with([&](auto& c) { c.woods = {{id, plants::SpeciesMix{60}, 120, 12}}; }), "wood");
  EXPECT_EQ(wrong_with([&](auto& c) { c.plantings = {{id, plants::SpeciesMix{}, 7, 2, 2, 3}}; }), "");
  EXPECT_EQ(wrong_with([&](auto& c) { c.plantings = {{id, plants::SpeciesMix{}, 7, 2, 0.125, 3}}; }), "planting");
  EXPECT_EQ(wrong_with([&](auto& c) {
              c.tree_rows = {{id, {{1, 2}}, plants::SpeciesMix{}, 7, 2}};
            }),
            "tree row points");
  EXPECT_EQ(wrong_with([&](auto& c) { c.heights.resampling_error_m = -1; }), "field");
}

TEST(ChunkCodec, AFlagIsNoughtOrOne) {
  scene::Chunk chunk = made_chunk(7);
  chunk.buildings.resize(1);
  chunk.buildings[0].footprint.outer = {{0, 0}, {1, 0}, {0, 1}};
  Streams streams = encode_chunk(chunk, kSeed);
  ASSERT_EQ(streams["building stands"].size(), 1u);
  streams["building stands"].front() = 2;
  EXPECT_EQ(wrong_in(streams), "building stands");
}

TEST(ChunkCodec, AHeightBeyond32BitsIsNamed) {
  Streams streams = empty_streams();
  ASSERT_EQ(streams["heights"].size(), 4u);
  streams["heights"] = stream_of({0, 0, 0, std::uint64_t{1} << 40});
  EXPECT_EQ(wrong_in(streams), "heights");
}

// 100 000 rings of as many points as the chunk has bytes, none of which exists: a reader that trusts counts would
// allocate a terabyte.
TEST(ChunkCodec, CountsAreNotBelievedBeforeTheirThings) {
  Streams streams = empty_streams();
  streams["x"].assign(1 << 20, 0);
  streams["surfaces"] = stream_of({1}), streams["id type"] = stream_of({1}), streams["id"] = stream_of({2}),
  streams["part"] = stream_of({0}), streams["surface class"] = stream_of({0}), streams["surface area"] = stream_of({0}),
  streams["surface rings"] = stream_of({100000});
  for (int i = 0; i < 100000; ++i)
    for (const std::uint8_t byte : stream_of({1 << 20})) streams["ring points"].push_back(byte);
  EXPECT_EQ(wrong_in(streams), "points");
}

TEST(ChunkCodec, KeepsHowAnAxisDrifts) {
  scene::Chunk chunk;
  chunk.tile = kTile;
  chunk.heights = {{0, 0}, {64, 64}, 2, 2, {0, 0, 0, 0}, 0};
  for (const double drift : {-0.5, -0x1p-16, 0.0, 0x1p-16, 0.125, 0.5}) {
    const ObjectId id{{OsmType::kWay, static_cast<std::int64_t>(chunk.roads.size()) + 1}, 0};
    chunk.roads.push_back(one_lane(id, {{1, 2}, {3, 4}}));
    chunk.roads.back().section.axis_drift = drift;
  }
  std::string wrong;
  const auto back = decode_chunk(encode_chunk(chunk, kSeed), kTile, kSeed, wrong);
  ASSERT_TRUE(back) << wrong;
  EXPECT_EQ(back->roads, chunk.roads);
}

}  // namespace
}  // namespace citykiln::exporters

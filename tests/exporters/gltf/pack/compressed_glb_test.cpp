#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "compiler/geometry/snap.h"
#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/pack/quantise.h"
#include "exporters/gltf/packed_grids.h"
#include "exporters/gltf/write/encode_tile.h"
#include "tests/exporters/made_tile.h"
#include "tests/test_files.h"

namespace citykiln::exporters {
namespace {

using bake::BakedTile;
using bake::Float3;
using bake::Primitive;
using Bytes = std::vector<std::byte>;

constexpr Compression kCompressions[] = {Compression::kLean, Compression::kQuantize, Compression::kDraco,
                                         Compression::kMeshopt};

Bytes compressed_glb(const BakedTile& tile, Compression compression, Target target = Target::kCesium, int threads = 1) {
  const GlbOptions options{.target = target, .compression = compression, .has_exact_pictures = true};
  return encode_tile(tile, {}, options, threads).glb;
}

BakedTile through(const BakedTile& tile, Compression compression, Target target = Target::kCesium) {
  const auto back = decode_glb(compressed_glb(tile, compression, target), "tile.glb");
  EXPECT_TRUE(back) << (back ? "" : to_string(back.error()));
  return back ? *back : BakedTile{};
}

// All attributes of a vertex but its normal; -1 for missing ones.
using AttributesOfCorner = std::array<float, 10>;
using AttributesOfCorners = std::array<AttributesOfCorner, 3>;

AttributesOfCorner corner_of(const Primitive& p, std::uint32_t v) {
  const float feature = p.features.empty() ? -1.0f : static_cast<float>(p.features[v]);
  const bake::Float2 uv = p.uvs.empty() ? bake::Float2{-1, -1} : p.uvs[v];
  const auto& [r, g, b, a] = p.colours[v];
  const Float3& at = p.positions[v];
  return {at[0], at[1], at[2], feature, uv[0], uv[1], float(r), float(g), float(b), float(a)};
}

// Sorted triangles, each from its smallest corner on, with the normals of their corners. Either side of a
// leaf may be read as its front.
std::multimap<AttributesOfCorners, std::array<Float3, 3>> triangles_of(const Primitive& p) {
  std::multimap<AttributesOfCorners, std::array<Float3, 3>> triangles;
  for (auto t : p.triangles) {
    const auto less = [&](std::uint32_t a, std::uint32_t b) { return corner_of(p, a) < corner_of(p, b); };
    if (p.colour_source == materials::ColourSource::kByCutout) std::ranges::sort(t, less);
    std::ranges::rotate(t, std::ranges::min_element(t, less));
    triangles.insert({{corner_of(p, t[0]), corner_of(p, t[1]), corner_of(p, t[2])},
                      {p.normals[t[0]], p.normals[t[1]], p.normals[t[2]]}});
  }
  return triangles;
}

double degrees_between(const Float3& a, const Float3& b) {
  double square = 0;
  for (std::size_t c = 0; c < 3; ++c) square += (double{a[c]} - b[c]) * (double{a[c]} - b[c]);
  return 2 * std::asin(std::min(1.0, std::sqrt(square) / 2)) * 180 / 3.14159265358979;
}

void expect_same(const Primitive& found, const Primitive& expected) {
  EXPECT_EQ(key_of(found), key_of(expected));
  const auto have = triangles_of(found), want = triangles_of(expected);
  ASSERT_EQ(have.size(), want.size());
  for (auto h = have.begin(), w = want.begin(); w != want.end(); ++h, ++w) {
    ASSERT_EQ(h->first, w->first);
    for (std::size_t k = 0; k < 3; ++k) ASSERT_LT(degrees_between(h->second[k], w->second[k]), 1);
  }
}

void expect_same(const std::vector<Primitive>& found, const std::vector<Primitive>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) expect_same(found[i], expected[i]);
}

// Compares tiles but for the order of vertices and triangles, and for the last bits of normals.
void expect_same(BakedTile found, BakedTile expected) {
  expect_same(found.primitives, expected.primitives);
  ASSERT_EQ(found.instanced.size(), expected.instanced.size());
  for (std::size_t i = 0; i < found.instanced.size(); ++i) {
    expect_same(found.instanced[i].primitives, expected.instanced[i].primitives);
    found.instanced[i].primitives = expected.instanced[i].primitives;
  }
  found.primitives = expected.primitives, found.object_error_m = expected.object_error_m;
  EXPECT_EQ(found, expected);
}

// Positions that are on no grid, as those of walls and roofs.
BakedTile off_grid(std::uint32_t seed) {
  std::mt19937 dice(seed);
  BakedTile tile = made_facade_tile(seed);
  const auto jog = [&](std::vector<Primitive>& primitives) {
    for (Primitive& p : primitives)
      for (Float3& at : p.positions)
        for (float& c : at) c += static_cast<float>(dice() % 1000) * 1e-5f;
  };
  jog(tile.primitives);
  for (bake::InstancedMesh& instanced : tile.instanced) jog(instanced.primitives);
  return tile;
}

TEST(CompressedGlb, HoldsTheQuantisedTileTriangleForTriangle) {
  for (std::uint32_t seed = 0, seeds = quick_or_full(3, 10); seed < seeds; ++seed)
    for (const Compression compression : kCompressions)
      for (const Target target : {Target::kCesium, Target::kUnreal})
        for (const BakedTile& tile : {made_tile(seed), made_marked_tile(seed), made_facade_tile(seed),
                                      made_textured_tile(seed), off_grid(seed)})
          ASSERT_NO_FATAL_FAILURE(expect_same(through(tile, compression, target), quantised(tile, compression)))
              << seed;
}

TEST(CompressedGlb, MoreCornersThan16BitsCount) {
  std::mt19937 dice(1);
  BakedTile tile = made_tile(1);
  tile.primitives = {made_primitive(dice, materials::Material::kRock, 65538, 4)};
  for (const Compression compression : kCompressions)
    ASSERT_NO_FATAL_FAILURE(expect_same(through(tile, compression), quantised(tile, compression)));
}

TEST(CompressedGlb, NoTriangleGoesEvenIfItsCornersMeet) {
  BakedTile tile = made_tile(1);
  Primitive& p = tile.primitives[1];
  for (std::size_t t = 0; t < 4; ++t) {
    const Float3 at = p.positions[3 * t];
    p.positions[3 * t + 1] = {at[0] + 0.0001f, at[1], at[2]};
    if (t % 2 == 0) p.positions[3 * t + 2] = {at[0], at[1] - 0.0001f, at[2]};
  }
  for (const Compression compression : kCompressions)
    ASSERT_NO_FATAL_FAILURE(expect_same(through(tile, compression), quantised(tile, compression)));
}

TEST(CompressedGlb, FarPlacesAreKept) {
  BakedTile tile = made_tile(1);
  tile.primitives[0].positions[0] = {-12000.5f, 9000.25f, 3.0f};
  for (const Compression compression : kCompressions)
    ASSERT_NO_FATAL_FAILURE(expect_same(through(tile, compression), quantised(tile, compression)));
}

// Positions on a border between two tiles, in the plane.
std::vector<Vec3> border() {
  std::mt19937 dice(7);
  std::vector<Vec3> places;
  for (int i = 0; i < 300; ++i) places.push_back(snapped(Vec3{1024, (dice() % 1024000) / 1000.0, dice() % 9 / 7.0}));
  return places;
}

// A tile with this border, and an origin and extent of its own.
BakedTile beside_border(std::uint32_t seed, Vec3 origin, double tolerance_m, bake::Layer layer) {
  std::mt19937 dice(seed);
  BakedTile tile = off_grid(seed);
  tile.origin = origin, tile.tolerance_m = tolerance_m;
  tile.primitives = {made_primitive(dice, materials::Material::kGrass, 900, 4, layer)};
  Primitive& p = tile.primitives[0];
  for (std::size_t i = 0; const Vec3& place : border())
    for (int c = 0; c < 3; ++c) p.positions[i][c] = static_cast<float>((&place.x)[c] - (&origin.x)[c]), i += c == 2;
  return tile;
}

std::vector<std::array<double, 3>> border_of(const BakedTile& tile) {
  std::vector<std::array<double, 3>> places;
  for (const Float3& p : tile.primitives[0].positions)
    if (tile.origin.x + p[0] == 1024) places.push_back({1024, tile.origin.y + p[1], tile.origin.z + p[2]});
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

// The ground stays, so that levels meet; all else is on one grid for the tiles of a level.
TEST(CompressedGlb, BordersOfTilesMeetAndOfLevelsOnTheGround) {
  for (const auto& [layer, step_m] : {std::pair(bake::Layer::kGround, kQuantum_m),
                                      std::pair(bake::Layer::kStructures, packed_position_step_m(0.1))}) {
    std::vector<std::array<double, 3>> expected;
    const auto on_grid = [step_m = step_m](double v) { return snapped_to(step_m, v); };
    for (const Vec3& p : border()) expected.push_back({on_grid(p.x), on_grid(p.y), on_grid(p.z)});
    std::ranges::sort(expected);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    const double beside_m = layer == bake::Layer::kGround ? 2.5 : 0.1;
    for (const Compression compression : {Compression::kQuantize, Compression::kDraco, Compression::kMeshopt}) {
      EXPECT_EQ(border_of(through(beside_border(1, {512, 512, 431}, 0.1, layer), compression)), expected);
      EXPECT_EQ(border_of(through(beside_border(2, {1536, 512, -7}, beside_m, layer), compression)), expected);
    }
  }
}

TEST(CompressedGlb, SameBytesForAnyThreads) {
  for (const Compression compression : kCompressions)
    for (const int threads : {2, 7})
      EXPECT_EQ(compressed_glb(off_grid(3), compression),
                compressed_glb(off_grid(3), compression, Target::kCesium, threads));
}

TEST(CompressedGlb, LeanKeepsPositionsErrorsAndNodes) {
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    const BakedTile tile = off_grid(seed), back = through(tile, Compression::kLean);
    EXPECT_EQ(back.error_m, tile.error_m);
    EXPECT_EQ(back.plant_error_m, tile.plant_error_m);
    const auto gltf = split_glb(compressed_glb(tile, Compression::kLean)).gltf;
    const auto plain = split_glb(compressed_glb(tile, Compression::kNone)).gltf;
    EXPECT_EQ(gltf["nodes"], plain["nodes"]);
    for (const auto& mesh : gltf["meshes"])
      for (const auto& primitive : mesh["primitives"]) {
        const auto& position = gltf["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
        EXPECT_EQ(position["componentType"], 5126);
      }
  }
}

TEST(CompressedGlb, NamesWhatReadersMustKnow) {
  const auto required = [](Compression compression) {
    return split_glb(compressed_glb(made_tile(1), compression)).gltf["extensionsRequired"];
  };
  EXPECT_EQ(required(Compression::kLean), nlohmann::json({"KHR_mesh_quantization"}));
  EXPECT_EQ(required(Compression::kDraco), nlohmann::json({"KHR_draco_mesh_compression"}));
  EXPECT_EQ(required(Compression::kMeshopt), nlohmann::json({"EXT_meshopt_compression", "KHR_mesh_quantization"}));
}

TEST(CompressedGlb, ATileWithoutMeshesIsWhole) {
  BakedTile bare = made_tile(1);
  bare.instanced.clear(), bare.primitives.clear();
  for (const Compression compression : kCompressions) EXPECT_EQ(through(bare, compression), bare);
}

double largest_move_m(const std::vector<Primitive>& a, const std::vector<Primitive>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < 3 * a[i].triangles.size(); ++k) {
      const Float3 &p = a[i].positions[a[i].triangles[k / 3][k % 3]], &q = b[i].positions[b[i].triangles[k / 3][k % 3]];
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c) square += std::pow(double{p[c]} - double{q[c]}, 2);
      largest = std::max(largest, std::sqrt(square));
    }
  return largest;
}

TEST(Quantised, StatesAtLeastTheErrorMeasured) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const BakedTile tile = off_grid(seed), packed = quantised(tile, Compression::kQuantize);
    double measured_m = largest_move_m(tile.primitives, packed.primitives), largest_scale = 1;
    for (std::size_t i = 0; i < tile.instanced.size(); ++i)
      for (const float scale : tile.instanced[i].scales) {
        measured_m =
            std::max(measured_m, scale * largest_move_m(tile.instanced[i].primitives, packed.instanced[i].primitives));
        largest_scale = std::max<double>(largest_scale, scale);
      }
    EXPECT_GT(measured_m, 0.0005);
    EXPECT_GE(packed.error_m + 1e-15, tile.error_m + measured_m);
    EXPECT_LE(packed.error_m,
              tile.error_m + largest_scale * packed_position_step_m(tile.tolerance_m) * std::sqrt(0.75) + 1e-4);
  }
}

TEST(Rounding, IsNothingOnTheGridAndHalfALastBitElsewhere) {
  EXPECT_EQ(rounding_m(made_tile(1).primitives), 0);
  BakedTile tile = made_tile(1);
  tile.primitives[0].positions[0] = {300.1f, 0.1f, 0};
  EXPECT_GE(rounding_m(tile.primitives), std::abs(300.1 - double{300.1f}));
  EXPECT_LT(rounding_m(tile.primitives), 4e-5);
}

TEST(Quantised, WhatIsOnTheGridStays) {
  BakedTile tile = made_tile(1);
  for (Primitive& p : tile.primitives)
    for (Float3& at : p.positions)
      for (float& c : at) c = static_cast<float>(snapped_to(packed_position_step_m(tile.tolerance_m), c));
  tile.instanced.clear();
  const BakedTile packed = quantised(tile, Compression::kQuantize);
  EXPECT_EQ(packed.error_m, tile.error_m);
  EXPECT_EQ(largest_move_m(tile.primitives, packed.primitives), 0);
}

TEST(Quantised, EqualVerticesAreSharedAndNoTriangleGoes) {
  BakedTile tile = made_tile(1);
  Primitive& p = tile.primitives[0];
  const std::size_t vertices = p.positions.size();
  // every vertex twice, and each second triangle on the copies
  for (auto* values : {&p.positions, &p.normals}) values->insert(values->end(), values->begin(), values->end());
  p.colours.insert(p.colours.end(), p.colours.begin(), p.colours.end());
  p.features.insert(p.features.end(), p.features.begin(), p.features.end());
  p.uvs.insert(p.uvs.end(), p.uvs.begin(), p.uvs.end());
  const std::size_t triangles = p.triangles.size();
  for (std::size_t t = 0; t < triangles; ++t) {
    auto copy = p.triangles[t];
    copy[0] += static_cast<std::uint32_t>(vertices);
    p.triangles.push_back(copy);
  }
  const BakedTile packed = quantised(tile, Compression::kQuantize);
  EXPECT_LE(packed.primitives[0].positions.size(), vertices);
  EXPECT_EQ(packed.primitives[0].triangles.size(), 2 * triangles);
}

TEST(Quantised, VerticesOfTrianglesWithoutAnAreaGo) {
  BakedTile tile = made_tile(1);
  Primitive& p = tile.primitives[0];
  const BakedTile expected = quantised(tile, Compression::kQuantize);
  const auto v = static_cast<std::uint32_t>(p.positions.size());
  for (int copy = 0; copy < 3; ++copy) {
    for (auto* values : {&p.positions, &p.normals}) values->push_back(Float3{values->back()});
    p.colours.push_back(materials::Tint{p.colours.back()});
    if (!p.features.empty()) p.features.push_back(std::uint32_t{p.features.back()});
    if (!p.uvs.empty()) p.uvs.push_back(bake::Float2{p.uvs.back()});
  }
  p.positions[v][0] += 100, p.positions[v + 1][0] += 100, p.positions[v + 2][0] += 200;
  p.triangles.push_back({v, v + 1, v + 2});
  EXPECT_EQ(quantised(tile, Compression::kQuantize), expected);
}

TEST(Quantised, TwiceIsOnce) {
  for (const Compression compression : {Compression::kLean, Compression::kQuantize}) {
    const BakedTile once = quantised(off_grid(1), compression);
    EXPECT_EQ(quantised(once, compression), once);
  }
}

TEST(CompressedGlbDamage, EveryTruncationIsRefused) {
  for (const Compression compression : kCompressions) {
    const Bytes bytes = compressed_glb(made_tile(2), compression);
    ASSERT_FALSE(bytes.empty());
    for (std::size_t size = 0; size < bytes.size(); ++size)
      ASSERT_FALSE(decode_glb(std::span(bytes).first(size), "cut")) << size;
  }
}

TEST(CompressedGlbDamage, AChangedByteIsRefusedOrMakesAnotherTile) {
  std::mt19937 dice(4);
  for (const Compression compression : kCompressions) {
    const Bytes bytes = compressed_glb(made_marked_tile(3), compression);
    ASSERT_FALSE(bytes.empty());
    for (std::size_t at = 0; at < bytes.size(); at += 1 + dice() % quick_or_full(40, 13)) {
      Bytes changed = bytes;
      changed[at] ^= static_cast<std::byte>(1 + dice() % 255);
      const auto tile = decode_glb(changed, "changed");
      if (!tile) continue;
      const auto again =
          decode_glb(encode_glb(*tile, {}, {.target = Target::kGodot, .has_exact_pictures = true}), "again");
      ASSERT_TRUE(again) << "byte " << at << ": " << to_string(again.error());
      ASSERT_EQ(without_uvs(*again), without_uvs(*tile)) << "byte " << at;
    }
  }
}

// The file with other JSON.
std::string compressed_refusal(Compression compression, const std::string& text, const std::string& other) {
  GlbParts parts = split_glb(compressed_glb(made_tile(1), compression));
  std::string json = parts.gltf.dump();
  const auto at = json.find(text);
  EXPECT_NE(at, std::string::npos) << text << " in " << json;
  if (at == std::string::npos) return "";
  parts.gltf = nlohmann::json::parse(json.replace(at, text.size(), other));
  const auto tile = decode_glb(join_glb(parts), "tile.glb");
  return tile ? "accepted" : to_string(tile.error());
}

TEST(CompressedGlbDamage, ViewsThatClaimMoreThanTheyHoldAreRefused) {
  EXPECT_NE(compressed_refusal(Compression::kMeshopt, "\"count\":9,\"filter\"", "\"count\":900000000,\"filter\""),
            "accepted");
  EXPECT_NE(compressed_refusal(Compression::kMeshopt, "\"byteStride\":12,\"count\"", "\"byteStride\":252,\"count\""),
            "accepted");
  EXPECT_NE(compressed_refusal(Compression::kMeshopt, "\"OCTAHEDRAL\"", "\"EXPONENTIAL\""), "accepted");
  EXPECT_NE(compressed_refusal(Compression::kDraco, "\"POSITION\":", "\"POSITION\":7777"), "accepted");
}

TEST(CompressedGlbDamage, MeshesAreUnpackedOnce) {
  GlbParts parts = split_glb(compressed_glb(made_tile(1), Compression::kDraco));
  nlohmann::json& primitives = parts.gltf["meshes"][0]["primitives"];
  for (int i = 0; i < 20; ++i) primitives.push_back(primitives[0]);
  const auto tile = decode_glb(join_glb(parts), "tile.glb");
  ASSERT_FALSE(tile);
  EXPECT_NE(to_string(tile.error()).find("each byte of the buffer to be used once"), std::string::npos);
}

}  // namespace
}  // namespace citykiln::exporters

#include "exporters/gltf/flat_shading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>
#include <string>

#include "exporters/gltf/glb.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Primitive;

// Boxes at random places: 24 vertices each, three normals at a corner.
Primitive boxes(std::uint32_t seed, int count) {
  std::minstd_rand random(seed);
  const auto place = [&] { return static_cast<float>(random() % 4096) / 8; };
  Primitive p;
  for (int b = 0; b < count; ++b) {
    const Float3 low{place(), place(), place()}, size{1 + place() / 64, 1 + place() / 64, 1 + place() / 64};
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        const auto first = static_cast<std::uint32_t>(p.positions.size());
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const auto& [i, k] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          Float3 at = low, normal{};
          at[axis] += static_cast<float>(side) * size[axis], normal[axis] = side == 1 ? 1.0F : -1.0F;
          at[u] += static_cast<float>(side == 1 ? i : k) * size[u],
              at[v] += static_cast<float>(side == 1 ? k : i) * size[v];
          p.positions.push_back(at), p.normals.push_back(normal), p.colours.push_back({}), p.features.push_back(0);
        }
        p.triangles.push_back({first, first + 1, first + 2}), p.triangles.push_back({first, first + 2, first + 3});
      }
  }
  return p;
}

// The corners of a triangle with their normals.
using PlaceAndNormal = std::pair<Float3, Float3>;
std::vector<std::array<PlaceAndNormal, 3>> corners_of(const Primitive& p) {
  std::vector<std::array<PlaceAndNormal, 3>> all;
  for (const auto& t : p.triangles) {
    std::array<PlaceAndNormal, 3> corners;
    for (int i = 0; i < 3; ++i) corners[i] = {p.positions[t[i]], p.normals[t[i]]};
    all.push_back(corners);
  }
  return all;
}

TEST(FlatShading, OfBoxesIsExact) {
  for (std::uint32_t seed = 1; seed < 50; ++seed) {
    const Primitive made = boxes(seed, 20);
    ASSERT_TRUE(is_flat(made));
    const Primitive bare = without_normals(Primitive(made));
    EXPECT_TRUE(bare.normals.empty());
    const Primitive back = with_face_normals(bare);
    EXPECT_EQ(back.positions.size(), 20u * 24);
    ASSERT_EQ(corners_of(back), corners_of(made));
    EXPECT_EQ(back.features.size(), back.positions.size());
    EXPECT_EQ(back.colours.size(), back.positions.size());
  }
}

TEST(FlatShading, FacesOfOneFeatureShareCorners) {
  Primitive quads;
  quads.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}};
  quads.normals.assign(4, {0, 0, 1}), quads.normals.resize(8, {-1, 0, 0});
  quads.colours.assign(8, materials::kNoTint), quads.features.assign(8, 3);
  quads.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
  EXPECT_EQ(without_normals(Primitive(quads)).positions.size(), 6u);
  std::fill_n(quads.features.begin(), 4, 2u);
  EXPECT_EQ(without_normals(Primitive(quads)).positions.size(), 8u);
}

TEST(FlatShading, IsNotThatOfRoundShapes) {
  Primitive round = boxes(1, 1);
  ASSERT_EQ(round.normals[0], (Float3{-1, 0, 0}));
  const auto lean = [&](float degrees) {
    const float angle = degrees * 3.14159265F / 180;
    round.normals[0] = {-std::cos(angle), std::sin(angle), 0};
  };
  lean(0.9F);
  EXPECT_TRUE(is_flat(round));
  lean(1.1F);
  EXPECT_FALSE(is_flat(round));
}

bool says_normals(std::span<const std::byte> glb) {
  return std::string(reinterpret_cast<const char*>(glb.data()), glb.size()).find("\"NORMAL\"") != std::string::npos;
}

TEST(FlatShading, IsWrittenForReadersThatKnowIt) {
  bake::BakedTile tile;
  tile.features = {OsmId{}}, tile.primitives = {boxes(3, 4000)};
  const auto written = [&](Target target) { return encode_glb(tile, {}, {.target = target}); };
  const auto bare = written(Target::kBlender), full = written(Target::kGodot);
  EXPECT_FALSE(says_normals(bare));
  EXPECT_TRUE(says_normals(full));
  EXPECT_LT(bare.size(), full.size() * 3 / 4);
  const Result<bake::BakedTile> back = decode_glb(bare, "tile.glb");
  ASSERT_TRUE(back) << to_string(back.error());
  ASSERT_EQ(back->primitives.size(), 1u);
  EXPECT_EQ(corners_of(back->primitives[0]), corners_of(tile.primitives[0]));
  // a single round place keeps all normals
  tile.primitives[0].normals[0] = {0, 0, 1};
  EXPECT_TRUE(says_normals(written(Target::kBlender)));
}

TEST(FlatShading, OfATriangleWithoutAreaIsUp) {
  Primitive line = boxes(1, 1);
  line.triangles = {{0, 1, 0}};
  EXPECT_TRUE(is_flat(line));
  line.normals.clear();
  for (const Float3& normal : with_face_normals(line).normals) EXPECT_EQ(normal, (Float3{0, 0, 1}));
}

TEST(FlatShading, DividesARunWithRoundNormalsFromFlatOnes) {
  Primitive p = boxes(1, 4);
  for (std::size_t v = 24; v < 48; ++v) p.normals[v] = {0.6F, 0, 0.8F};
  const ByShading parts = by_shading(p);
  EXPECT_EQ(parts.smooth.triangles.size(), 12u);
  EXPECT_EQ(parts.flat.triangles.size(), 36u);
  EXPECT_TRUE(is_flat(parts.flat));
  EXPECT_EQ(by_shading(boxes(1, 4)).smooth.triangles.size(), 0u);
}

}  // namespace
}  // namespace citykiln::exporters

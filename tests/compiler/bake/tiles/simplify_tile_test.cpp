#include "compiler/bake/tiles/simplify_tile.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::bake {
namespace {

constexpr double kFlatTile_m = 64;

void add_feature_triangle(Primitive& p, Float3 a, Float3 b, Float3 c, std::uint32_t feature) {
  const auto first = static_cast<std::uint32_t>(p.positions.size());
  for (const Float3& at : {a, b, c}) {
    p.positions.push_back(at), p.normals.push_back({0, 0, 1});
    p.colours.push_back(materials::kNoTint), p.features.push_back(feature);
  }
  p.triangles.push_back({first, first + 1, first + 2});
}

void add_feature_quad(Primitive& p, Float3 a, Float3 b, Float3 c, Float3 d, std::uint32_t feature) {
  add_feature_triangle(p, a, b, c, feature), add_feature_triangle(p, a, c, d, feature);
}

Primitive primitive_on(Layer layer) {
  Primitive p{.material = {}, .positions = {}, .normals = {}, .colours = {}, .features = {}, .triangles = {}};
  p.layer = layer;
  return p;
}

// Two tiles from (0, 0) to (128, 64): flat ground in steps of 4 m with skirts on all sides of both.
BakedTile two_tiles() {
  Primitive ground = primitive_on(Layer::kGround);
  const auto at = [](int x, int y) { return Float3{static_cast<float>(x), static_cast<float>(y), 0}; };
  for (int x = 0; x < 128; x += 4)
    for (int y = 0; y < 64; y += 4) add_feature_quad(ground, at(x, y), at(x + 4, y), at(x + 4, y + 4), at(x, y + 4), 1);
  const auto skirt = [&](Float3 a, Float3 b) {
    add_feature_quad(ground, a, {a[0], a[1], -30}, {b[0], b[1], -30}, b, 1);
  };
  for (int y = 0; y < 64; y += 4)
    for (const int x : {0, 64, 64, 128}) skirt(at(x, y), at(x, y + 4));
  return {.tile = {0, 0},
          .origin = {0, 0, 0},
          .tolerance_m = 1,
          .error_m = 1,
          .features = {OsmId{}, {OsmType::kWay, 7}, {OsmType::kWay, 9}},
          .primitives = {ground}};
}

std::size_t skirts_at(const BakedTile& tile, float x) {
  std::size_t count = 0;
  for (const Primitive& p : tile.primitives)
    for (const auto& t : p.triangles) count += std::ranges::all_of(t, [&](auto v) { return p.positions[v][0] == x; });
  return count;
}

TEST(SimplifyTile, RemovesSkirtsBetweenTilesOnly) {
  BakedTile tile = two_tiles();
  EXPECT_EQ(skirts_at(tile, 64), 64u);
  remove_inner_skirts(tile, {{0, 0}, {1, 0}}, kFlatTile_m);
  EXPECT_EQ(skirts_at(tile, 64), 0u);
  EXPECT_EQ(skirts_at(tile, 0), 32u);
  EXPECT_EQ(skirts_at(tile, 128), 32u);
}

TEST(SimplifyTile, KeepsSkirtsBesideATileThatIsNotThere) {
  BakedTile tile = two_tiles();
  remove_inner_skirts(tile, {{0, 0}}, kFlatTile_m);
  EXPECT_EQ(skirts_at(tile, 64), 64u);
}

TEST(SimplifyTile, LeavesFewTrianglesOfFlatGroundAndAllOnTheBorder) {
  BakedTile tile = two_tiles();
  remove_inner_skirts(tile, {{0, 0}, {1, 0}}, kFlatTile_m);
  simplify_terrain(tile, {{0, 0}, {128, 64}}, 0.5);
  const Primitive& ground = tile.primitives.front();
  EXPECT_LT(ground.triangles.size(), 300u);
  EXPECT_GE(tile.error_m, 1);
  EXPECT_LE(tile.error_m, 1.5);
  for (int x = 0; x <= 128; x += 4)
    EXPECT_TRUE(std::ranges::find(ground.positions, Float3{static_cast<float>(x), 0, 0}) != ground.positions.end());
  for (const std::uint32_t feature : ground.features) EXPECT_EQ(feature, 0u);
}

void add_box(Primitive& p, float x, float y, float side, float height, std::uint32_t feature) {
  const Float3 a{x, y, height}, b{x + side, y, height}, c{x + side, y + side, height}, d{x, y + side, height};
  const auto low = [](Float3 at) { return Float3{at[0], at[1], 0}; };
  add_feature_quad(p, a, b, c, d, feature);
  add_feature_quad(p, low(a), low(b), b, a, feature), add_feature_quad(p, low(b), low(c), c, b, feature);
  add_feature_quad(p, low(c), low(d), d, c, feature), add_feature_quad(p, low(d), low(a), a, d, feature);
}

TEST(SimplifyTile, DropsWhatIsNearTheTerrainAndKeepsTowers) {
  BakedTile tile = two_tiles();
  Primitive buildings = primitive_on(Layer::kBuildings);
  add_box(buildings, 10, 10, 8, 12, 2), add_box(buildings, 40, 10, 8, 90, 2);
  tile.primitives.push_back(buildings);
  drop_near_terrain(tile, 20);
  ASSERT_EQ(tile.primitives.size(), 2u);
  EXPECT_EQ(tile.primitives[1].triangles.size(), 10u);
  for (const Float3& p : tile.primitives[1].positions) EXPECT_GE(p[0], 40);
  EXPECT_GE(tile.error_m, 1 + 12);
  EXPECT_LE(tile.error_m, 1 + 20);
}

// Two copies of a box of 1 m, scaled to the heights.
InstancedMesh two_boxes(Layer layer, float first_m, float second_m) {
  InstancedMesh mesh{.name = "box", .primitives = {primitive_on(layer)}};
  add_box(mesh.primitives[0], 0, 0, 0.1f, 1, 0);
  mesh.translations = {{10, 10, 0}, {90, 20, 0}}, mesh.rotations = {{0, 0, 0, 1}, {0, 0, 0.6f, 0.8f}};
  mesh.scales = {first_m, second_m}, mesh.features = {1, 2};
  return mesh;
}

TEST(SimplifyTile, KeepsThingsThatTheToleranceDoesNotHide) {
  BakedTile tile = two_tiles();
  tile.instanced = {two_boxes(Layer::kProps, 12, 140), two_boxes(Layer::kPlants, 25, 30)};
  drop_near_terrain(tile, 50);
  ASSERT_EQ(tile.instanced.size(), 1u);
  const InstancedMesh& things = tile.instanced[0];
  EXPECT_EQ(things.scales, std::vector<float>{140});
  EXPECT_EQ(things.translations.size(), 1u);
  EXPECT_EQ(things.rotations.size(), 1u);
  EXPECT_EQ(things.features, std::vector<std::uint32_t>{2});
  EXPECT_EQ(tile.plant_error_m, 30);
  EXPECT_GE(tile.error_m, 1 + 12);
  EXPECT_LE(tile.error_m, 1 + 12 + 2);
}

TEST(SimplifyTile, DropsFeaturesThatNothingHas) {
  BakedTile tile = two_tiles();
  tile.attributes = {{}, {"Park", "", 0}, {"Church", "", 0}};
  tile.primitives.front().features.assign(tile.primitives.front().features.size(), 2);
  drop_unused_features(tile);
  EXPECT_EQ(tile.features, (std::vector<OsmId>{OsmId{}, {OsmType::kWay, 9}}));
  EXPECT_EQ(tile.attributes[1].kind, "Church");
  EXPECT_EQ(tile.primitives.front().features.front(), 1u);
}

}  // namespace
}  // namespace citykiln::bake

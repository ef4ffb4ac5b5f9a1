#include "compiler/bake/parts/stands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/geometry/segment.h"

namespace citykiln::bake {
namespace {

constexpr OsmId kWood{OsmType::kWay, 7};
const Box2 kTile{{-512, -512}, {512, 512}};

// A wood of 20 trees of two variants, and three mapped trees.
plants::PlacedPlants made_plants() {
  plants::PlacedPlants placed;
  for (int i = 0; i < 20; ++i)
    placed[{plants::Species{}, static_cast<std::uint8_t>(i % 2)}].push_back({{10.0 * i, 5, 1}, 0.6, 0.8, 12, kWood});
  for (int i = 0; i < 3; ++i)
    placed[{plants::Species{}, 0}].push_back({{10.0 * i, 50, 1}, 1, 0, 8, {OsmType::kNode, 100 + i}});
  return placed;
}

std::size_t count_of(const plants::PlacedPlants& placed) {
  std::size_t count = 0;
  for (const auto& [prototype, placements] : placed) count += placements.size();
  return count;
}

TEST(Stands, TakeNothingWhereThereAreFewPlants) {
  plants::PlacedPlants placed = made_plants();
  EXPECT_TRUE(take_stands(placed, {kTile, {}}, 0.5, 23).empty());
  EXPECT_EQ(count_of(placed), 23u);
}

TEST(Stands, TakeWoodsAndLeaveMappedTrees) {
  plants::PlacedPlants placed = made_plants();
  const Stands stands = take_stands(placed, {kTile, {}}, 0.5, 22);
  EXPECT_EQ(count_of(placed), 3u);
  std::size_t taken = 0;
  for (const auto& [key, placements] : stands) {
    EXPECT_EQ(key.element, kWood);
    EXPECT_FALSE(key.is_inner);
    taken += placements.size();
  }
  EXPECT_EQ(taken, 20u);
}

// Coarse trees beside a street were blobs of leaves as wide as a car.
TEST(Stands, TreesOfRoadsStay) {
  plants::PlacedPlants placed = made_plants();
  roads::Road road;
  road.id = {kWood, 2};
  road.axis = {{0, 0}, {200, 0}};
  EXPECT_TRUE(take_stands(placed, {kTile, std::span(&road, 1)}, 0.5, 0).empty());
  EXPECT_EQ(count_of(placed), 23u);
}

// A wood of 200 by 200 m in the corner of a tile, with a glade of 40 m and a path: the inside begins 8 to 45 m behind
// its edges, but at the tile's border, beyond which it goes on.
TEST(Stands, PlantsAreInsideWhereTheWoodGoesOnAllAround) {
  plants::PlacedPlants placed;
  const Box2 glade{{-400, -400}, {-360, -360}};
  roads::Road path;
  path.axis = {{-512, -450}, {-400, -450}};
  for (double x = -510; x < -312; x += 5)
    for (double y = -510; y < -312; y += 5)
      if (!glade.contains({x, y})) placed[{plants::Species{}, 0}].push_back({{x, y, 0}, 1, 0, 12, kWood});
  std::size_t inner = 0, all = 0;
  for (const auto& [key, placements] : take_stands(placed, {kTile, std::span(&path, 1)}, 0.1, 0))
    for (const Placement& p : placements) {
      const Vec2 at = in_plan(p.at);
      const double to_edge =
          std::min({-312 - at.x, -312 - at.y, std::max(std::abs(at.x + 380), std::abs(at.y + 380)) - 20,
                    distance_to_polyline(path.axis, at)});
      ++all, inner += key.is_inner;
      EXPECT_TRUE(!key.is_inner || to_edge >= 8) << at.x << ' ' << at.y;
      EXPECT_TRUE(key.is_inner || to_edge <= 45) << at.x << ' ' << at.y;
    }
  EXPECT_GT(all, 1500u);
  EXPECT_GT(inner, 300u);
}

TEST(Stands, ShowEachPlantWhereItsInstanceWouldBe) {
  constexpr double kHeight_m = 16;
  BakedPrototype prototype;
  Primitive leaf;
  leaf.positions = {{0, 0, 0}, {kHeight_m, 0, 0}, {0, 0, kHeight_m}};
  leaf.normals.assign(3, {1, 0, 0}), leaf.colours.assign(3, materials::kNoTint), leaf.triangles = {{0, 1, 2}};
  leaf.layer = Layer::kPlants;
  prototype.primitives = {leaf};
  const std::vector<Placement> plants = {{{110, 205, 31}, 1, 0, 12, kWood}, {{130, 205, 33}, 0, 1, 10, kWood}};
  const InstancedMesh stand = stand_mesh(prototype, kHeight_m, plants, {100, 200, 30}, 5);
  EXPECT_EQ(stand.translations, (std::vector<Float3>{{10, 5, 1}}));
  EXPECT_EQ(stand.features, (std::vector<std::uint32_t>{5}));
  ASSERT_EQ(stand.primitives.size(), 1u);
  // the second plant is turned by a quarter: x becomes y
  EXPECT_EQ(stand.primitives[0].positions,
            (std::vector<Float3>{{0, 0, 0}, {12, 0, 0}, {0, 0, 12}, {20, 0, 2}, {20, 10, 2}, {20, 0, 12}}));
  EXPECT_EQ(stand.primitives[0].normals[3], (Float3{0, 1, 0}));
  EXPECT_EQ(stand.primitives[0].triangles.size(), 2u);
  EXPECT_EQ(layer_of(stand), Layer::kPlants);
}

}  // namespace
}  // namespace citykiln::bake

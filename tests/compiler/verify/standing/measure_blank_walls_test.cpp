#include "compiler/verify/standing/measure_blank_walls.h"

#include <gtest/gtest.h>

#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

constexpr OsmId kHouseOnSlope{OsmType::kWay, 2}, kNeighbour{OsmType::kWay, 3};

// A house of 10 m by 10 m with storeys of 3 m, on ground at 10 m.
buildings::Building house_on_slope(double floor_m) {
  buildings::Building house;
  house.id = {kHouseOnSlope, 0};
  house.footprint.outer = {{20, 20}, {30, 20}, {30, 30}, {20, 30}};
  house.bottom_m = 4, house.floor_m = floor_m, house.top_m = floor_m + 6, house.levels = 2;
  return house;
}

void add_side(const Ring& ring, std::size_t i, double low_m, double high_m, bake::Primitive& mesh) {
  const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec3 p : {at_height(a, low_m), at_height(b, low_m), at_height(b, high_m), at_height(a, high_m)})
    mesh.positions.push_back(bake::narrowed(p - Vec3{0, 0, 10})), mesh.features.push_back(2);
  mesh.triangles.push_back({first, first + 1, first + 2}), mesh.triangles.push_back({first, first + 2, first + 3});
}

// The foundation and the walls of the house; walls of glass if it has windows.
bake::BakedTile tile_with(const buildings::Building& house, bool has_windows) {
  bake::BakedTile tile = made_ground(map::LandCoverClass::kGrass, {0, 0, 0, 0});
  tile.features.push_back(kHouseOnSlope), tile.features.push_back(kNeighbour);
  bake::Primitive foundation, walls;
  foundation.layer = walls.layer = bake::Layer::kBuildings;
  foundation.material = materials::Material::kStone;
  walls.material = has_windows ? materials::Material::kGlass : materials::Material::kPlaster;
  for (std::size_t i = 0; i < 4; ++i) {
    add_side(house.footprint.outer, i, house.bottom_m, house.floor_m, foundation);
    add_side(house.footprint.outer, i, house.floor_m, house.top_m, walls);
  }
  tile.primitives.push_back(foundation), tile.primitives.push_back(walls);
  return tile;
}

std::vector<BlankWall> blank_walls_of(const buildings::Building& house, const bake::BakedTile& tile) {
  scene::Chunk chunk;
  chunk.buildings = {house};
  return measure_blank_walls(chunk, tile, index_ground(tile));
}

TEST(MeasureBlankWalls, AreTheFoundationMoreThanAStoreyAboveTheGround) {
  const buildings::Building house = house_on_slope(18);
  const auto walls = blank_walls_of(house, tile_with(house, true));
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].building, kHouseOnSlope);
  EXPECT_NEAR(walls[0].area_m2, 4 * 10 * (18 - 10 - 3), 1e-6);
}

TEST(MeasureBlankWalls, AreNoneWhereTheFoundationIsNoHigherThanAStorey) {
  const buildings::Building house = house_on_slope(12.5);
  EXPECT_TRUE(blank_walls_of(house, tile_with(house, true)).empty());
}

TEST(MeasureBlankWalls, AreNoneOfBuildingsWithoutWindows) {
  const buildings::Building house = house_on_slope(18);
  EXPECT_TRUE(blank_walls_of(house, tile_with(house, false)).empty());
}

TEST(MeasureBlankWalls, AreNoneAgainstANeighbour) {
  const buildings::Building house = house_on_slope(18);
  bake::BakedTile tile = tile_with(house, true);
  for (std::uint32_t& feature : tile.primitives.front().features) feature = 3;  // the ground is a neighbour's floor
  scene::Chunk chunk;
  chunk.buildings = {house};
  chunk.surfaces = {{{kNeighbour, 0}, map::LandCoverClass::kBuilding, 9, {}}};
  EXPECT_TRUE(measure_blank_walls(chunk, tile, index_ground(tile)).empty());
}

// The jambs of an opening reach as far down as the foundation.
TEST(MeasureBlankWalls, AreNoneInAnOpeningForAWay) {
  buildings::Building house = house_on_slope(18);
  house.passageways = {{{{OsmType::kWay, 9}, 0}, {{10, 25}, {40, 25}}, 9, 9, 17}};
  EXPECT_TRUE(blank_walls_of(house, tile_with(house, true)).empty());
}

}  // namespace
}  // namespace citykiln::verify

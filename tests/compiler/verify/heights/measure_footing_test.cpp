#include "compiler/verify/heights/measure_footing.h"

#include <gtest/gtest.h>

#include "tests/compiler/verify/made_ground.h"

namespace citykiln::verify {
namespace {

constexpr OsmId kHouse{OsmType::kWay, 2};

buildings::Building house() {
  buildings::Building house;
  house.id = {kHouse, 0};
  house.footprint.outer = {{10, 10}, {20, 10}, {20, 20}, {10, 20}};
  house.bottom_m = 9, house.floor_m = 10, house.top_m = 20;
  return house;
}

/// Ground at 10 m and its house, whose walls reach down to a height above the tile's origin; the ground under it has a
/// kerb of the house's own.
bake::BakedTile tile_with_house(float bottom_m, std::array<float, 4> corners_m) {
  bake::BakedTile tile = made_ground(map::LandCoverClass::kGrass, corners_m);
  tile.features.push_back(kHouse);
  bake::Primitive walls;
  const Ring ring = house().footprint.outer;
  for (const Vec2 p : ring)
    for (const float z : {bottom_m, 10.0F})
      walls.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), z});
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % 4);
    walls.triangles.push_back({a, b, b + 1}), walls.triangles.push_back({a, b + 1, a + 1});
  }
  const auto kerb = static_cast<std::uint32_t>(walls.positions.size());
  walls.positions.insert(walls.positions.end(), {{10, 10, -5}, {20, 10, -5}, {20, 10, 0}});
  walls.triangles.push_back({kerb, kerb + 1, kerb + 2});
  walls.features.assign(walls.positions.size(), 2);
  walls.material = house().wall;
  walls.layer = bake::Layer::kBuildings;
  tile.primitives.push_back(walls);
  return tile;
}

Footing footing_of(const bake::BakedTile& tile) {
  scene::Chunk chunk;
  chunk.buildings = {house()};
  return measure_footing(chunk, kMadeBox, kAllowedGap_m, tile, index_ground(tile));
}

TEST(MeasureFooting, FindsNothingUnderWallsThatReachIntoTheGround) {
  const Footing footing = footing_of(tile_with_house(-1, {0, 0, 0, 0}));
  EXPECT_EQ(footing.corners, 4u);
  EXPECT_EQ(footing.floating.size(), 0u);
  EXPECT_EQ(footing.largest_gap_m, -1);
}

TEST(MeasureFooting, FindsAHouseThatFloats) {
  const Footing footing = footing_of(tile_with_house(0.5F, {0, 0, 0, 0}));
  EXPECT_EQ(footing.floating.size(), 1u);
  EXPECT_EQ(footing.largest_gap_m, 0.5);
  EXPECT_EQ(footing.worst, kHouse);
}

TEST(MeasureFooting, FindsOneCornerOverAHollow) {
  EXPECT_EQ(footing_of(tile_with_house(-1, {0, -6.4F, -6.4F, 0})).floating.size(), 1u);
}

// Walls in two strips, one below the other; and one whose lower strip is missing at a corner's edge.
TEST(MeasureFooting, FollowsWallsThatStandOnEachOther) {
  bake::BakedTile tile = tile_with_house(0.5F, {0, 0, 0, 0});
  bake::Primitive& walls = tile.primitives.back();
  const auto first = static_cast<std::uint32_t>(walls.positions.size());
  const Ring ring = house().footprint.outer;
  for (const Vec2 p : ring)
    for (const float z : {-1.0F, 0.5F})
      walls.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), z}), walls.features.push_back(2);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % 4);
    walls.triangles.push_back({a, b, b + 1}), walls.triangles.push_back({a, b + 1, a + 1});
  }
  EXPECT_EQ(footing_of(tile).largest_gap_m, -1);
}

// A corner at the edge of a street that is cut into the land: the house stands on the land.
TEST(MeasureFooting, TakesTheUpperSideOfAStepAtACorner) {
  bake::BakedTile tile = tile_with_house(-1, {0, 0, 0, 0});
  bake::Primitive& ground = tile.primitives.front();
  const auto first = static_cast<std::uint32_t>(ground.positions.size());
  const Ring ring = house().footprint.outer;
  const auto x = static_cast<float>(ring[0].x), y = static_cast<float>(ring[0].y);
  ground.positions.insert(ground.positions.end(), {{x - 4, y - 4, -5}, {x, y - 4, -5}, {x, y, -5}});
  ground.features.insert(ground.features.end(), 3, 1);
  ground.triangles.push_back({first, first + 1, first + 2});
  EXPECT_EQ(footing_of(tile).floating.size(), 0u);
}

// A coarse level moves a step by up to its error: the ground below a corner is the street's, and the land begins 2 m
// beside it. The land counts where the error is larger than that.
TEST(MeasureFooting, TakesTheUpperSideOfAStepThatALevelMoved) {
  bake::BakedTile tile = tile_with_house(-1, {0, 0, 0, 0});
  bake::Primitive& ground = tile.primitives.front();
  for (bake::Float3& p : ground.positions) p[2] = -9;
  const auto first = static_cast<std::uint32_t>(ground.positions.size());
  ground.positions.insert(ground.positions.end(), {{12, 8, 0}, {30, 8, 0}, {12, 30, 0}});
  ground.features.insert(ground.features.end(), 3, 1);
  ground.triangles.push_back({first, first + 1, first + 2});
  scene::Chunk chunk;
  chunk.buildings = {house()};
  const auto floating = [&](double allowed_m) {
    return measure_footing(chunk, kMadeBox, allowed_m, tile, index_ground(tile)).floating.size();
  };
  EXPECT_EQ(floating(1.5), 1u);
  EXPECT_EQ(floating(2.5), 0u);
}

TEST(MeasureFooting, SkipsRaisedBuildings) {
  scene::Chunk chunk;
  chunk.buildings = {house()};
  chunk.buildings.front().stands_on_ground = false;
  const bake::BakedTile tile = tile_with_house(5, {0, 0, 0, 0});
  EXPECT_EQ(measure_footing(chunk, kMadeBox, kAllowedGap_m, tile, index_ground(tile)).corners, 0u);
}

}  // namespace
}  // namespace citykiln::verify

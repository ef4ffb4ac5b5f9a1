#include "compiler/verify/measure_ways.h"

#include <gtest/gtest.h>

namespace citykiln::verify {
namespace {

using map::LandCoverClass;

constexpr OsmId kBlock{OsmType::kWay, 2}, kWay{OsmType::kWay, 9};
constexpr double kGround_m = 100;

roads::Road road_along(Polyline axis, LandCoverClass surface, double width_m) {
  roads::Road road;
  road.id = {kWay, 0};
  road.axis = std::move(axis);
  road.surface = surface;
  road.section.lanes = {{.width_m = width_m}};
  road.section.axis_offset_m = width_m / 2;
  return road;
}

// A block from x = 20 to 30 and y = -10 to 10; a road along y = 0 from x = 1 to 50.
scene::Chunk chunk_with_block(bool has_opening) {
  scene::Chunk chunk;
  buildings::Building block;
  block.id = {kBlock, 0};
  block.footprint.outer = {{20, -10}, {30, -10}, {30, 10}, {20, 10}};
  block.bottom_m = 97, block.floor_m = 100, block.top_m = 110;
  if (has_opening) block.passageways = {{{kWay, 0}, {{19, 0}, {31, 0}}, 2.0625, 2.0625, 104}};
  chunk.buildings = {block};
  chunk.roads = {road_along({{1, 0}, {50, 0}}, LandCoverClass::kServiceRoad, 4)};
  return chunk;
}

void add_wall(double from_y, double to_y, double low_m, double high_m, bake::Primitive& walls) {
  const auto first = static_cast<std::uint32_t>(walls.positions.size());
  for (const Vec3 p :
       {Vec3{20, from_y, low_m}, Vec3{20, to_y, low_m}, Vec3{20, to_y, high_m}, Vec3{20, from_y, high_m}})
    walls.positions.push_back(bake::narrowed(p - Vec3{0, 0, kGround_m})), walls.features.push_back(1);
  walls.triangles.push_back({first, first + 1, first + 2}), walls.triangles.push_back({first, first + 2, first + 3});
}

bake::BakedTile tile_of(const bake::Primitive& walls) {
  bake::BakedTile tile{{0, 0}, {0, 0, kGround_m}, 0.1, 0, {OsmId{}, kBlock}, {}, {}};
  tile.primitives = {walls};
  tile.primitives.front().layer = bake::Layer::kBuildings;
  return tile;
}

// The western wall, with an opening up to a height, or without.
bake::BakedTile tile_with_wall(double open_up_to_m) {
  bake::Primitive walls;
  if (open_up_to_m == 0) add_wall(-10, 10, 97, 110, walls);
  if (open_up_to_m > 0) add_wall(-10, -2.0625, 97, 110, walls), add_wall(2.0625, 10, 97, 110, walls);
  if (open_up_to_m > 0) add_wall(-2.0625, 2.0625, open_up_to_m, 110, walls);
  return tile_of(walls);
}

std::vector<WayIntoWall> ways_of(const scene::Chunk& chunk, const bake::BakedTile& tile) {
  return measure_ways(way_boxes_of(chunk, [](Vec2) { return kGround_m; }), tile);
}

TEST(MeasureWays, AreNoneInAnOpening) { EXPECT_TRUE(ways_of(chunk_with_block(true), tile_with_wall(104)).empty()); }

TEST(MeasureWays, AWallInAnOpeningIsFoundThere) {
  const auto ways = ways_of(chunk_with_block(true), tile_with_wall(0));
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_TRUE(ways[0].is_in_opening);
  EXPECT_EQ(ways[0].way, kWay);
  EXPECT_EQ(ways[0].building, kBlock);
  // kerbs below, and rounding at the sides, do not count
  EXPECT_NEAR(ways[0].area_m2, (4 - 0.04) * (3.5 - 0.5), 1e-6);
}

TEST(MeasureWays, ABeamBelowTheCeilingIsFound) {
  const auto ways = ways_of(chunk_with_block(true), tile_with_wall(103.25));
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_TRUE(ways[0].is_in_opening);
}

// The building is too low for cars, which is a finding of its own.
TEST(MeasureWays, EndAtTheCeilingOfALowOpening) {
  scene::Chunk chunk = chunk_with_block(true);
  chunk.buildings[0].passageways[0].top_m = 102.5;
  EXPECT_TRUE(ways_of(chunk, tile_with_wall(102.5)).empty());
}

TEST(MeasureWays, AWallWithoutAnOpeningIsFoundApart) {
  const auto ways = ways_of(chunk_with_block(false), tile_with_wall(0));
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_FALSE(ways[0].is_in_opening);
}

TEST(MeasureWays, WhatHangsAboveThemIsNoWall) {
  bake::Primitive walls;
  add_wall(-10, 10, 103.75, 110, walls);
  EXPECT_TRUE(ways_of(chunk_with_block(false), tile_of(walls)).empty());
  scene::Chunk path = chunk_with_block(false);
  path.roads = {road_along({{0, 0}, {50, 0}}, LandCoverClass::kFootPath, 2)};
  bake::Primitive low;
  add_wall(-10, 10, 102.125, 110, low);
  EXPECT_TRUE(ways_of(path, tile_of(low)).empty());
  EXPECT_FALSE(ways_of(chunk_with_block(false), tile_of(low)).empty());
}

TEST(MeasureWays, AWayThatEndsAtADoorMeetsNoWall) {
  scene::Chunk chunk = chunk_with_block(false);
  chunk.roads = {road_along({{0, -3}, {20, 0}}, LandCoverClass::kFootPath, 2)};
  EXPECT_TRUE(ways_of(chunk, tile_with_wall(0)).empty());
}

// The way is split at the wall, so its end there is no dead end.
TEST(MeasureWays, AWayThatGoesOnInsideIsFound) {
  scene::Chunk chunk = chunk_with_block(false);
  chunk.roads = {road_along({{0, 0}, {20.5, 0}}, LandCoverClass::kServiceRoad, 4),
                 road_along({{20.5, 0}, {50, 0}}, LandCoverClass::kServiceRoad, 4)};
  EXPECT_EQ(ways_of(chunk, tile_with_wall(0)).size(), 1u);
}

TEST(MeasureWays, RailwaysAreNotMeasured) {
  scene::Chunk chunk = chunk_with_block(false);
  chunk.roads = {road_along({{0, 0}, {50, 0}}, LandCoverClass::kRailway, 4)};
  EXPECT_TRUE(ways_of(chunk, tile_with_wall(0)).empty());
}

TEST(MeasureWays, OfSeveralLevelsAreOneForEachPair) {
  const auto all = combined({{kWay, kBlock, 1, {}}, {kWay, kBlock, 3, {}}, {kBlock, kBlock, 2, {}}});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].area_m2, 3);
  EXPECT_EQ(all[1].area_m2, 2);
}

}  // namespace
}  // namespace citykiln::verify

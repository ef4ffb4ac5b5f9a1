#include "compiler/fields/open_land.h"

#include <gtest/gtest.h>

namespace citykiln::fields {
namespace {

using map::LandCoverClass;

Ring block(Vec2 low, Vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

map::AreaFeature mapped_area(std::int64_t id, LandCoverClass surface, Ring outer) {
  const double own_m2 = signed_area_m2(outer);
  return {{{OsmType::kWay, id}, 0}, {std::move(outer), {}}, surface, own_m2, {}};
}

map::Footprint house(std::int64_t id, Vec2 low) {
  map::Footprint footprint;
  footprint.id = {{OsmType::kWay, id}, 0}, footprint.polygon = {block(low, low + Vec2{10, 10}), {}};
  return footprint;
}

TEST(OpenLand, IsFarmedOnlyWhereFarmlandIsMapped) {
  map::Features map;
  map.extent = {{0, 0}, {8192, 1024}};
  EXPECT_TRUE(open_squares(map).empty());
  map.areas = {mapped_area(1, LandCoverClass::kFarmland, block({10, 10}, {200, 200}))};
  const std::vector<map::AreaFeature> squares = open_squares(map);
  EXPECT_GE(squares.size(), 3u);
  for (const map::AreaFeature& square : squares) EXPECT_LE(square.polygon.outer.front().x, 200 + kFarmedAbout_m);
}

TEST(OpenLand, FieldsYieldToTownsAndBuildings) {
  map::Features map;
  map.extent = {{0, 0}, {1024, 1024}};
  map.areas = {mapped_area(1, LandCoverClass::kResidential, block({0, 0}, {100, 300}))};
  map.footprints = {house(2, {700, 100}), house(3, {720, 100}), house(4, {740, 150})};
  const OpenLand open(map);
  const OpenSquare square = open.square_at({0, 0}, [](Vec2) { return false; });
  EXPECT_FALSE(is_open(square, {90, 290}));
  EXPECT_TRUE(is_open(square, {110, 290})) << "beside the town";
  EXPECT_FALSE(is_open(square, {-10, 290})) << "in another square";
  const std::vector<Polygon> beside_town = open.free_parts(square, {block({50, 50}, {350, 290}), {}});
  ASSERT_EQ(beside_town.size(), 1u);
  EXPECT_NEAR(area_m2(beside_town[0]), 250 * 240, 1);
  EXPECT_TRUE(open.free_parts(square, {block({0, 0}, {150, 300}), {}}).empty()) << "most of it is a town";
  EXPECT_TRUE(open.free_parts(square, {block({650, 50}, {800, 250}), {}}).empty()) << "three houses stand on it";
}

TEST(OpenLand, FieldsKeepToLevelLand) {
  map::Features map;
  map.extent = {{0, 0}, {1024, 1024}};
  const OpenLand open(map);
  const OpenSquare square = open.square_at({0, 0}, [](Vec2 at) { return at.x > 512; });
  EXPECT_EQ(open_m2(square), kOpenSquare_m * kOpenSquare_m / 2);
  EXPECT_FALSE(open.free_parts(square, {block({100, 100}, {500, 400}), {}}).empty());
  EXPECT_TRUE(open.free_parts(square, {block({500, 100}, {900, 400}), {}}).empty());
}

TEST(OpenLand, CellsAboutABuildingAreClosed) {
  map::Features map;
  map.extent = {{0, 0}, {1024, 1024}};
  map.footprints = {house(2, {19, 507})};
  const OpenSquare square = OpenLand(map).square_at({0, 0}, [](Vec2) { return false; });
  EXPECT_EQ(open_m2(square), kOpenSquare_m * kOpenSquare_m - 9 * kOpenCell_m * kOpenCell_m);
  EXPECT_FALSE(is_open(square, {8, 500})) << "beside the cell of its middle";
  EXPECT_TRUE(is_open(square, {56, 512}));
}

TEST(OpenLand, CellsOfLandWithHolesAreThoseOutsideOfIt) {
  map::Features map;
  map.extent = {{0, 0}, {1024, 1024}};
  map::AreaFeature wood = mapped_area(1, LandCoverClass::kForest, block({-5000, -5000}, {5000, 5000}));
  const Ring clearing = block({200, 200}, {520, 360});
  wood.polygon.holes = {{clearing.rbegin(), clearing.rend()}};
  map.areas = {wood};
  const OpenSquare square = OpenLand(map).square_at({0, 0}, [](Vec2) { return false; });
  EXPECT_NEAR(open_m2(square), 320 * 160, 320 * 32);
  EXPECT_TRUE(is_open(square, {300, 300}));
  EXPECT_FALSE(is_open(square, {300, 100}));
}

}  // namespace
}  // namespace citykiln::fields

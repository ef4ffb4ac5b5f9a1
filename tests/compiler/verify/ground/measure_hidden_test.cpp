#include "compiler/verify/ground/measure_hidden.h"

#include <gtest/gtest.h>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;

constexpr Box2 kHiddenTile{{0, 0}, {256, 256}};

Ring square_ring(Vec2 corner, double side_m) {
  return {corner, corner + Vec2{side_m, 0}, corner + Vec2{side_m, side_m}, corner + Vec2{0, side_m}};
}

ground::LandCoverPolygon area_of(std::int64_t way, LandCoverClass surface, Vec2 corner, double side_m) {
  return {.id = {{OsmType::kWay, way}, 0},
          .surface = surface,
          .area_m2 = static_cast<std::uint32_t>(side_m * side_m),
          .rings = {square_ring(corner, side_m)}};
}

HiddenThings hidden_areas(const std::vector<ground::LandCoverPolygon>& surfaces) {
  return measure_hidden_areas(ground::index_land_cover(surfaces, kHiddenTile), kHiddenTile);
}

TEST(MeasureHidden, AnAreaBelowALargerOneIsHidden) {
  auto pond = area_of(1, LandCoverClass::kGrass, {20, 20}, 10);
  const auto plaza = area_of(2, LandCoverClass::kLake, {0, 0}, 100);
  const HiddenThings found = hidden_areas({pond, plaza});
  EXPECT_EQ(found.tests, 2u);
  EXPECT_EQ(found.hidden, 1u);
  EXPECT_EQ(found.element.id, 1);
  EXPECT_EQ(found.on_top.id, 2);
  pond.raised_priority = 255;
  EXPECT_EQ(hidden_areas({pond, plaza}).hidden, 0u);
}

TEST(MeasureHidden, AnAreaIsSeenWhereItIsOnTopAtOnePlaceOrSmallerOnesLieOnIt) {
  const auto pond = area_of(1, LandCoverClass::kGrass, {95, 20}, 20);
  EXPECT_EQ(hidden_areas({pond, area_of(2, LandCoverClass::kLake, {0, 0}, 100)}).hidden, 0u);
  EXPECT_EQ(hidden_areas({pond, area_of(2, LandCoverClass::kLake, {94, 19}, 20)}).hidden, 0u) << "of the same size";
}

HiddenThings hidden_track(Polyline street, double width_m) {
  scene::Chunk chunk;
  chunk.roads = {roads::made_road(7, {{8, 50}, {248, 50}}, 3, LandCoverClass::kRailway, 0, 0)};
  const Vec2 along = unit(street[1] - street[0]), aside = left_of(along) * (width_m / 2);
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {.id = {{OsmType::kWay, 8}, 0},
       .surface = LandCoverClass::kResidentialRoad,
       .area_m2 = ground::kStripArea_m2,
       .rings = {{street[0] - aside, street[1] - aside, street[1] + aside, street[0] + aside}}}};
  return measure_hidden_tracks(chunk, ground::index_land_cover(surfaces, kHiddenTile), kHiddenTile);
}

TEST(MeasureHidden, ATrackAlongBelowACarriagewayIsHiddenAndACrossingIsNot) {
  const HiddenThings along = hidden_track({{0, 50}, {256, 50}}, 8);
  EXPECT_GT(along.hidden, along.tests / 2);
  EXPECT_EQ(along.element.id, 7);
  EXPECT_EQ(along.on_top.id, 8);
  const HiddenThings across = hidden_track({{100, 0}, {140, 100}}, 12);
  EXPECT_GT(across.tests, 50u);
  EXPECT_EQ(across.hidden, 0u);
}

}  // namespace
}  // namespace citykiln::verify

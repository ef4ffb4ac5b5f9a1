#include "compiler/furniture/road_things.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/compiler/roads/made_road.h"

namespace citykiln::furniture {
namespace {

const Box2 kRoadTile{{0, 0}, {512, 512}};

// A street of two lanes with a crossing that has an island.
roads::Road crossed_with_island(double lane_m) {
  roads::Road road =
      roads::made_road(1, {{100, 100}, {200, 100}, {300, 100}}, lane_m, map::LandCoverClass::kTertiaryRoad, 2, 2);
  map::Lane back = road.section.lanes[1];
  road.section.lanes[1].way = map::LaneDirection::kForward, back.way = map::LaneDirection::kBackward;
  road.section.lanes.insert(road.section.lanes.begin() + 1, back);
  road.section.axis_offset_m = lane_m;
  road.points = {{.vertex = 1, .kind = map::TrackPointKind::kZebra, .traits = map::kCrossingIsland}};
  return road;
}

std::vector<things::Thing> refuges_of(const roads::Road& road) {
  const std::vector<roads::Road> roads = {road};
  const ground::LandCoverIndex index = ground::index_land_cover({}, kRoadTile);
  return refuges({.roads = roads,
                  .junctions = {},
                  .yards = {},
                  .pitches = {},
                  .trunks = {},
                  .things = {},
                  .lamps = {},
                  .barriers = {},
                  .buildings = {},
                  .land_cover = index,
                  .tile_m = 512},
                 kRoadTile);
}

TEST(Refuges, StandBeforeAndBehindACrossingWithAnIsland) {
  const std::vector<things::Thing> made = refuges_of(crossed_with_island(4));
  ASSERT_EQ(made.size(), 2u);
  for (const things::Thing& refuge : made) {
    EXPECT_NEAR(refuge.at.y, 100, 0.01);
    EXPECT_NEAR(std::abs(refuge.at.x - 200), 2 + refuge.form.depth_m / 2, 0.01);
  }
}

TEST(Refuges, NeedRoomAndAMappedIsland) {
  EXPECT_TRUE(refuges_of(crossed_with_island(3)).empty());
  roads::Road plain = crossed_with_island(4);
  plain.points[0].traits = 0;
  EXPECT_TRUE(refuges_of(plain).empty());
}

// A street for walkers, 8 m wide, that ends at a street for cars, on land that is all of one class.
std::vector<things::Thing> on_walked_street(map::LandCoverClass land, map::CountryGroup country,
                                            const std::vector<things::Thing>& mapped = {}) {
  std::vector<roads::Road> roads = {
      roads::made_road(1, {{100, 100}, {200, 100}, {300, 100}}, 6, map::LandCoverClass::kResidentialRoad),
      roads::made_road(2, {{200, 100}, {200, 400}}, 8, map::LandCoverClass::kPedestrianStreet)};
  for (roads::Road& road : roads) road.country = country;
  roads::Junction junction;
  junction.nodes = {{200, 100}};
  const std::vector<roads::Junction> junctions = {junction};
  std::vector<roads::Junction> cut = junctions;
  cut[0].cuts.assign(roads::arms_of(junctions, roads)[0].size(), {.length_m = 5});
  const std::vector<ground::LandCoverPolygon> cover = {
      {{{OsmType::kWay, 9}, 0}, land, 0, {{{0, 0}, {512, 0}, {512, 512}, {0, 512}}}}};
  const ground::LandCoverIndex index = ground::index_land_cover(cover, kRoadTile);
  const roadside::TileRecipes recipes{.roads = roads,
                                      .junctions = cut,
                                      .yards = {},
                                      .pitches = {},
                                      .trunks = {},
                                      .things = mapped,
                                      .lamps = {},
                                      .barriers = {},
                                      .buildings = {},
                                      .land_cover = index,
                                      .tile_m = 512};
  std::vector<things::Thing> all;
  for (std::uint64_t seed = 0; seed < 8; ++seed)
    for (things::Thing& thing :
         things_of_walked_streets(recipes, roadside::clear_zones_of(recipes), {}, seed, kRoadTile))
      all.push_back(std::move(thing));
  return all;
}

std::ptrdiff_t count_of(const std::vector<things::Thing>& things, std::string_view kind) {
  return std::ranges::count_if(things, [&](const things::Thing& thing) { return thing.form.kind == kind; });
}

TEST(WalkedStreets, HaveBollardsAcrossTheirMouthAndPlanters) {
  const auto made = on_walked_street(map::LandCoverClass::kPedestrianStreet, map::CountryGroup::kSouthernEurope);
  EXPECT_GT(count_of(made, "bollard"), 5);
  EXPECT_GT(count_of(made, "planter"), 10);
  for (const things::Thing& thing : made) {
    EXPECT_LE(std::abs(thing.at.x - 200), 4);
    if (thing.form.kind == "bollard") {
      EXPECT_NEAR(thing.at.y, 106, 0.1);
    }
  }
}

TEST(WalkedStreets, HaveNothingOffPavingAndBollardsWhereTheyAreUsualAndNotMapped) {
  using enum map::CountryGroup;
  EXPECT_TRUE(on_walked_street(map::LandCoverClass::kBuilding, kSouthernEurope).empty());
  EXPECT_EQ(count_of(on_walked_street(map::LandCoverClass::kSquare, kJapan), "bollard"), 0);
  things::Thing gate;
  gate.at = {203, 104}, gate.form.kind = "swing_gate";
  EXPECT_EQ(count_of(on_walked_street(map::LandCoverClass::kSquare, kSouthernEurope, {gate}), "bollard"), 0);
}

}  // namespace
}  // namespace citykiln::furniture

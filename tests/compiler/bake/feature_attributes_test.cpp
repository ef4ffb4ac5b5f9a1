#include "compiler/bake/feature_attributes.h"

#include <gtest/gtest.h>

#include "compiler/map/buildings/building_classes.h"

namespace citykiln::bake {
namespace {

ObjectId way(std::int64_t id, std::uint32_t part = 0) { return {{OsmType::kWay, id}, part}; }

scene::Chunk town() {
  scene::Chunk chunk;
  buildings::Building house;
  house.id = way(7), house.floor_m = 100, house.bottom_m = 97, house.top_m = 112.5;
  house.building_class = static_cast<std::uint8_t>(map::BuildingClass::kHouse);
  chunk.buildings = {house};
  house.id = way(7, 1), house.top_m = 108;
  chunk.buildings.push_back(house);
  house.id = way(8), house.bottom_m = 110, house.floor_m = 110, house.top_m = 120, house.stands_on_ground = false;
  house.building_class = static_cast<std::uint8_t>(map::BuildingClass::kPlain);
  chunk.buildings.push_back(house);
  roads::Road road;
  road.id = way(9), road.surface = map::LandCoverClass::kResidentialRoad;
  chunk.roads = {road};
  chunk.surfaces = {{way(7), map::LandCoverClass::kPark, 500, {}}, {way(10), map::LandCoverClass::kForest, 500, {}}};
  chunk.barriers = {{way(11), {}, map::BarrierKind::kCityWall, 6, 1}};
  chunk.texts = {{way(7).osm, "Town Hall", {{"building", "yes"}}}, {way(9).osm, "Main Street"}};
  return chunk;
}

TEST(FeatureAttributes, AreThoseOfTheRecipes) {
  std::vector<OsmId> features = {{}};
  for (const int id : {7, 8, 9, 10, 11, 12}) features.push_back(way(id).osm);
  EXPECT_EQ(attributes_of(town(), features),
            (std::vector<FeatureAttributes>{{},
                                            {"House", "Town Hall", 12.5f, {{"building", "yes"}}},
                                            {"Building", "", 10},
                                            {"ResidentialRoad", "Main Street", 0},
                                            {"Forest", "", 0},
                                            {"CityWall", "", 6},
                                            {}}));
}

TEST(FeatureAttributes, HaveWhatIsAssumedOfAnyRecipeOfTheElement) {
  scene::Chunk chunk = town();
  chunk.buildings[1].assumed = bit_of(Assumption::kHeights), chunk.buildings[0].assumed = bit_of(Assumption::kRoofs);
  chunk.roads[0].assumed = bit_of(Assumption::kLamps);
  const std::vector<OsmId> features = {{}, way(7).osm, way(8).osm, way(9).osm};
  const auto rows = attributes_of(chunk, features);
  EXPECT_EQ(rows[1].assumed, bit_of(Assumption::kHeights) | bit_of(Assumption::kRoofs));
  EXPECT_EQ(rows[2].assumed, kNoAssumptions);
  EXPECT_EQ(rows[3].assumed, bit_of(Assumption::kLamps));
}

TEST(FeatureAttributes, OfNoFeaturesAreNone) { EXPECT_TRUE(attributes_of(town(), {}).empty()); }

}  // namespace
}  // namespace citykiln::bake

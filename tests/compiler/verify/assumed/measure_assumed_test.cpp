#include "compiler/verify/assumed/measure_assumed.h"

#include <gtest/gtest.h>

#include "compiler/buildings/planning/doors.h"
#include "compiler/contract/derived_id.h"
#include "compiler/map/things/thing_role.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;

constexpr Box2 kTile{{0, 0}, {128, 128}};
constexpr OsmId kMainStreet{OsmType::kWay, 1}, kMappedWay{OsmType::kWay, 2};

roads::Road way_along(OsmId id, Polyline axis, LandCoverClass surface, double width_m) {
  roads::Road road;
  road.id = {id, 0};
  road.axis = std::move(axis);
  road.surface = surface;
  road.section.lanes = {{.width_m = width_m}};
  road.section.axis_offset_m = width_m / 2;
  return road;
}

// A street of 6 m along y = 50 with assumed pavements of 2 m.
scene::Chunk street_with_pavements() {
  scene::Chunk chunk;
  roads::Road street = way_along(kMainStreet, {{0, 50}, {120, 50}}, LandCoverClass::kResidentialRoad, 6);
  const map::Lane pavement{.kind = map::LaneKind::kSidewalk, .width_m = 2, .is_raised = true};
  street.section.lanes = {pavement, street.section.lanes.front(), pavement};
  street.assumed = bit_of(Assumption::kPavements), street.assumed_sides = map::kBothSides;
  chunk.roads = {street};
  return chunk;
}

AssumedTests pavements_beside(const roads::Road& other) {
  scene::Chunk chunk = street_with_pavements();
  chunk.roads.push_back(other);
  return measure_assumed_pavements(chunk, kTile);
}

TEST(MeasureAssumed, FindsNothingBesideAFreeStreet) {
  const AssumedTests found = measure_assumed_pavements(street_with_pavements(), kTile);
  EXPECT_EQ(found.tested, 60u);
  EXPECT_EQ(found.conflicts, 0u);
}

TEST(MeasureAssumed, TestsPlacesAtMostFourMetresApart) {
  scene::Chunk chunk = street_with_pavements();
  chunk.roads[0].axis = {{0, 50}, {7.5, 50}};
  EXPECT_EQ(measure_assumed_pavements(chunk, kTile).tested, 4u) << "two on either side";
}

TEST(MeasureAssumed, LooksOnlyAtRoadsWithAssumedPavements) {
  scene::Chunk chunk = street_with_pavements();
  chunk.roads[0].assumed = bit_of(Assumption::kLamps);
  EXPECT_EQ(measure_assumed_pavements(chunk, kTile).tested, 0u);
}

TEST(MeasureAssumed, FindsPavementsInWaterBuildingsAndSquares) {
  const Ring beside = {{20, 53.5}, {40, 53.5}, {40, 60}, {20, 60}};
  for (const LandCoverClass surface :
       {LandCoverClass::kLake, LandCoverClass::kBuilding, LandCoverClass::kSquare, LandCoverClass::kPark}) {
    scene::Chunk chunk = street_with_pavements();
    chunk.surfaces = {{{kMappedWay, 0}, surface, 130, {beside}}};
    const AssumedTests found = measure_assumed_pavements(chunk, kTile);
    EXPECT_EQ(found.conflicts, surface == LandCoverClass::kPark ? 0u : 5u);
    EXPECT_EQ(found.obstacle, found.conflicts > 0 ? kMappedWay : OsmId{});
  }
}

// A causeway lies in the water with all of its lanes.
TEST(MeasureAssumed, AllowsWaterUnderTheStreetItself) {
  scene::Chunk chunk = street_with_pavements();
  chunk.surfaces = {{{kMappedWay, 0}, LandCoverClass::kLake, 4000, {{{0, 0}, {128, 0}, {128, 128}, {0, 128}}}}};
  EXPECT_EQ(measure_assumed_pavements(chunk, kTile).conflicts, 0u);
}

TEST(MeasureAssumed, FindsPavementsOnRailwaysAndRoadsBesideTheStreet) {
  for (const LandCoverClass surface : {LandCoverClass::kRailway, LandCoverClass::kServiceRoad})
    EXPECT_EQ(pavements_beside(way_along(kMappedWay, {{0, 54}, {120, 54}}, surface, 2)).conflicts, 30u);
}

TEST(MeasureAssumed, FindsPavementsOnPathsAlongTheStreetButNotBelowCyclePathsAndFootways) {
  const auto conflicts_on = [](LandCoverClass surface) {
    return pavements_beside(way_along(kMappedWay, {{0, 54}, {120, 54}}, surface, 2)).conflicts;
  };
  EXPECT_EQ(conflicts_on(LandCoverClass::kBridleway), 30u);
  EXPECT_EQ(conflicts_on(LandCoverClass::kCyclePath), 0u) << "it lies on the pavement";
  EXPECT_EQ(conflicts_on(LandCoverClass::kPavedFootPath), 0u) << "it lies in the pavement";
}

TEST(MeasureAssumed, AllowsPathsAndWaysThatJoinTheStreet) {
  EXPECT_EQ(pavements_beside(way_along(kMappedWay, {{60, 20}, {60, 90}}, LandCoverClass::kPavedFootPath, 2)).conflicts,
            0u);
  EXPECT_EQ(pavements_beside(way_along(kMappedWay, {{0, 50}, {0, 90}}, LandCoverClass::kServiceRoad, 4)).conflicts, 0u);
}

TEST(MeasureAssumed, FindsLampsOnACarriageway) {
  scene::Chunk chunk = street_with_pavements();
  chunk.roads[0].assumed = bit_of(Assumption::kLamps);
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {{kMainStreet, 0}, LandCoverClass::kResidentialRoad, 1, {{{0, 47}, {120, 47}, {120, 53}, {0, 53}}}}};
  const ground::LandCoverIndex cover = ground::index_land_cover(surfaces, kTile);
  bake::BakedTile tile;
  tile.features = {{}, kMainStreet, kMappedWay};
  tile.instanced.resize(1);
  tile.instanced[0].name = "PostTopLamp";
  tile.instanced[0].translations = {{10, 54, 0}, {30, 52, 0}, {50, 52, 0}};
  tile.instanced[0].features = {1, 1, 2};
  const AssumedTests found = measure_assumed_lamps(tile, chunk, cover);
  EXPECT_EQ(found.tested, 2u);
  EXPECT_EQ(found.conflicts, 1u);
  EXPECT_EQ(found.at, (Vec2{30, 52}));
}

// A car of 2 by 4 m that stands at a place, with its front to the south.
bake::BakedTile tile_with_car(bake::Float3 at) {
  bake::BakedTile tile;
  tile.features = {{}, kMainStreet};
  tile.instanced.resize(1);
  tile.instanced[0].name = "car_2";
  tile.instanced[0].translations = {at}, tile.instanced[0].rotations = {{0, 0, 0, 1}};
  tile.instanced[0].features = {1};
  tile.instanced[0].primitives.resize(1);
  tile.instanced[0].primitives[0].positions = {{-1, -2, 0}, {1, -2, 0}, {1, 2, 1}};
  return tile;
}

TEST(MeasureAssumed, FindsCarsOffThePavedGroundAndInBuildings) {
  const scene::Chunk chunk = street_with_pavements();
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {{kMainStreet, 0}, LandCoverClass::kResidentialRoad, 1, {{{0, 47}, {120, 47}, {120, 53}, {0, 53}}}},
      {{kMappedWay, 0}, LandCoverClass::kBuilding, 1, {{{60, 51}, {120, 51}, {120, 80}, {60, 80}}}}};
  const ground::LandCoverIndex cover = ground::index_land_cover(surfaces, kTile);
  EXPECT_EQ(measure_parked_cars(tile_with_car({30, 50, 0}), chunk, cover).tested, 1u);
  EXPECT_EQ(measure_parked_cars(tile_with_car({30, 50, 0}), chunk, cover).conflicts, 0u);
  EXPECT_EQ(measure_parked_cars(tile_with_car({30, 54, 0}), chunk, cover).conflicts, 1u);
  EXPECT_EQ(measure_parked_cars(tile_with_car({90, 50, 0}), chunk, cover).obstacle, kMappedWay);
}

// A person at a place, and a box of 1 m for a thing at another.
bake::BakedTile tile_with_person(bake::Float3 person, bake::Float3 thing, const char* name) {
  bake::BakedTile tile = tile_with_car(person);
  tile.instanced[0].name = "person_3";
  bake::InstancedMesh other = tile.instanced[0];
  other.name = name, other.translations = {thing};
  other.primitives[0].layer = bake::Layer::kProps;
  other.primitives[0].positions = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 1}};
  tile.instanced.push_back(other);
  return tile;
}

TEST(MeasureAssumed, FindsPeopleInTheCarriagewayAndInThings) {
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {{kMainStreet, 0}, LandCoverClass::kResidentialRoad, 1, {{{0, 47}, {120, 47}, {120, 53}, {0, 53}}}},
      {{kMainStreet, 0}, LandCoverClass::kPavement, 1, {{{0, 53}, {120, 53}, {120, 56}, {0, 56}}}},
      {{kMappedWay, 0}, LandCoverClass::kBuilding, 1, {{{60, 56}, {120, 56}, {120, 80}, {60, 80}}}}};
  const ground::LandCoverIndex cover = ground::index_land_cover(surfaces, kTile);
  const auto conflicts = [&](bake::Float3 person, const char* thing = "planter") {
    return measure_people(tile_with_person(person, {20, 54.5, 0}, thing), cover).conflicts;
  };
  EXPECT_EQ(measure_people(tile_with_person({30, 54, 0}, {20, 54.5, 0}, "planter"), cover).tested, 1u);
  EXPECT_EQ(conflicts({30, 54, 0}), 0u);
  EXPECT_EQ(conflicts({30, 50, 0}), 1u);
  EXPECT_EQ(conflicts({90, 55.9F, 0}), 1u) << "a shoulder in the wall";
  EXPECT_EQ(conflicts({20.25F, 54.75F, 0}), 1u);
  EXPECT_EQ(conflicts({20.25F, 54.75F, 0}, "bench_2"), 0u);
}

TEST(MeasureAssumed, FindsCarsBeforeDoors) {
  scene::Chunk chunk = street_with_pavements();
  buildings::Building house;
  house.id = {kMappedWay, 0};
  house.footprint.outer = {{20, 54}, {40, 54}, {40, 64}, {20, 64}};
  house.facade_edges.resize(4);
  house.facade_edges[0].doors = 1;
  chunk.buildings = {house};
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {{kMainStreet, 0}, LandCoverClass::kResidentialRoad, 1, {{{0, 40}, {120, 40}, {120, 54}, {0, 54}}}}};
  const ground::LandCoverIndex cover = ground::index_land_cover(surfaces, kTile);
  const std::vector<Vec2> doors = buildings::door_positions(house);
  ASSERT_EQ(doors.size(), 1u);
  const auto car_before_door = [&](float gap_m) {
    return measure_parked_cars(tile_with_car({static_cast<float>(doors[0].x), 54 - 2 - gap_m, 0}), chunk, cover);
  };
  EXPECT_EQ(car_before_door(0.5).conflicts, 1u);
  EXPECT_EQ(car_before_door(2).conflicts, 0u);
}

// Baskets of 0.4 by 0.4 m that descend from an element.
bake::BakedTile tile_with_baskets(std::vector<bake::Float3> places, OsmId element = kMainStreet) {
  bake::BakedTile tile;
  tile.features = {{}, element};
  tile.instanced.resize(1);
  bake::InstancedMesh& mesh = tile.instanced[0];
  mesh.name = "waste_basket_2", mesh.translations = std::move(places);
  mesh.rotations.assign(mesh.translations.size(), {0, 0, 0, 1}), mesh.features.assign(mesh.translations.size(), 1);
  mesh.primitives.resize(1);
  mesh.primitives[0].positions = {{-0.2f, -0.2f, 0}, {0.2f, -0.2f, 0}, {0.2f, 0.2f, 1}};
  return tile;
}

TEST(MeasureAssumed, FindsFurnitureOnCarriagewaysBeforeDoorsAndInOtherFurniture) {
  scene::Chunk chunk = street_with_pavements();
  buildings::Building house;
  house.id = {kMappedWay, 0};
  house.footprint.outer = {{20, 58}, {40, 58}, {40, 68}, {20, 68}};
  house.facade_edges.resize(4);
  house.facade_edges[0].doors = 1;
  chunk.buildings = {house};
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {{kMainStreet, 0}, LandCoverClass::kResidentialRoad, 1, {{{0, 47}, {120, 47}, {120, 53}, {0, 53}}}}};
  const ground::LandCoverIndex cover = ground::index_land_cover(surfaces, kTile);
  const auto conflicts = [&](std::vector<bake::Float3> places) {
    return measure_street_furniture(tile_with_baskets(std::move(places)), chunk, cover).conflicts;
  };
  EXPECT_EQ(conflicts({{60, 54, 0}, {62, 54, 0}}), 0u);
  EXPECT_EQ(conflicts({{60, 53, 0}, {62, 54, 0}}), 1u) << "a corner on the carriageway";
  EXPECT_EQ(conflicts({{60, 54, 0}, {60.3f, 54, 0}}), 1u);
  const Vec2 door = buildings::door_positions(house).front();
  EXPECT_EQ(conflicts({{static_cast<float>(door.x), 57.5f, 0}}), 1u);
  EXPECT_EQ(measure_street_furniture(tile_with_baskets({{60, 53, 0}}, {OsmType::kNode, 77}), chunk, cover).tested, 0u)
      << "mapped";
}

// A house of 20 by 10 m with an assumed front on its southern wall, from 5 to 11 m.
scene::Chunk house_with_front() {
  buildings::Building house;
  house.id = {kMappedWay, 0};
  house.footprint.outer = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
  house.fronts = {{.edge = 0, .from_m = 5, .to_m = 11, .is_assumed = true}};
  scene::Chunk chunk;
  chunk.buildings = {house};
  return chunk;
}

TEST(MeasureAssumed, FindsHedgesInBuildings) {
  scene::Chunk chunk;
  props::Barrier hedge{.id = field_id({kMappedWay, 0}, 5), .axis = {{10, 20}, {60, 20}}};
  chunk.barriers = {hedge, {.id = {kMainStreet, 0}, .axis = {{10, 20}, {60, 20}}}};
  std::vector<ground::LandCoverPolygon> cover = {
      {{kMainStreet, 0}, LandCoverClass::kBuilding, 400, {{{30, 10}, {40, 10}, {40, 30}, {30, 30}}}}};
  const auto conflicts = [&] {
    return measure_assumed_hedges(chunk, ground::index_land_cover(cover, kTile), kTile).conflicts;
  };
  EXPECT_EQ(conflicts(), 5u);
  cover[0].surface = LandCoverClass::kMeadow;
  EXPECT_EQ(conflicts(), 0u);
}

TEST(MeasureAssumed, AllowsFrontsBesidePartyWallsAndOtherFronts) {
  scene::Chunk chunk = house_with_front();
  chunk.buildings[0].party_walls = {{.edge = 0, .from_m = 0, .to_m = 5, .top_m = 9},
                                    {.edge = 1, .from_m = 0, .to_m = 10}};
  chunk.buildings[0].fronts.push_back({.edge = 0, .from_m = 11, .to_m = 15});
  const AssumedTests found = measure_assumed_fronts(chunk);
  EXPECT_EQ(found.tested, 1u);
  EXPECT_EQ(found.conflicts, 0u);
}

TEST(MeasureAssumed, FindsFrontsOnWallsThatAreNotFree) {
  scene::Chunk chunk = house_with_front();
  buildings::Building& house = chunk.buildings[0];
  house.party_walls = {{.edge = 0, .from_m = 0, .to_m = 6}};
  EXPECT_EQ(measure_assumed_fronts(chunk).conflicts, 1u);
  house.party_walls.clear();
  house.passageways = {{{kMainStreet, 0}, {{8, -1}, {8, 11}}, 2, 2, 4}};
  EXPECT_EQ(measure_assumed_fronts(chunk).conflicts, 1u);
  house.passageways.clear();
  house.fronts[0].to_m = 21;
  EXPECT_EQ(measure_assumed_fronts(chunk).conflicts, 1u);
  house.fronts = {{.edge = 0, .from_m = 5, .to_m = 11, .is_assumed = true}, {.edge = 0, .from_m = 10, .to_m = 15}};
  EXPECT_EQ(measure_assumed_fronts(chunk).conflicts, 1u);
}

scene::Chunk chunk_with_railing(Polyline axis) {
  scene::Chunk chunk;
  chunk.barriers = {{{kMappedWay, kFirstDerivedPart}, std::move(axis), map::BarrierKind::kRailing, 1.1, 0.06}};
  return chunk;
}

TEST(MeasureAssumed, FindsRailingsAcrossWaysBeforeDoorsAndOnCarriageways) {
  const scene::Chunk free = chunk_with_railing({{10, 30}, {50, 30}});
  const auto measured = [](const scene::Chunk& chunk, const std::vector<ground::LandCoverPolygon>& surfaces) {
    return measure_assumed_railings(chunk, ground::index_land_cover(surfaces, kTile), kTile);
  };
  EXPECT_GT(measured(free, {}).tested, 40u);
  EXPECT_EQ(measured(free, {}).conflicts, 0u);
  const Ring around = {{20, 25}, {30, 25}, {30, 35}, {20, 35}};
  for (const LandCoverClass surface : {LandCoverClass::kResidentialRoad, LandCoverClass::kSteps, LandCoverClass::kLake,
                                       LandCoverClass::kBuilding, LandCoverClass::kSquare}) {
    const bool is_free = surface == LandCoverClass::kSquare;
    EXPECT_EQ(measured(free, {{{kMainStreet, 0}, surface, 100, {around}}}).conflicts == 0, is_free);
  }
  scene::Chunk crossed = free;
  crossed.roads = {way_along(kMainStreet, {{30, 10}, {30, 50}}, LandCoverClass::kPavedFootPath, 2)};
  EXPECT_EQ(measured(crossed, {}).conflicts, 1u);
  crossed.roads[0].id.osm = kMappedWay;
  EXPECT_EQ(measured(crossed, {}).conflicts, 0u) << "its own way";
  scene::Chunk with_door = free;
  with_door.buildings.resize(1);
  with_door.buildings[0].footprint.outer = {{29, 33}, {29, 30.5}, {31, 30.5}, {31, 33}};
  with_door.buildings[0].facade_edges.assign(4, {});
  EXPECT_EQ(measured(with_door, {}).conflicts, 0u);
  with_door.buildings[0].facade_edges[1].doors = 1 << 8;
  EXPECT_GT(measured(with_door, {}).conflicts, 0u);
}

TEST(MeasureAssumed, FindsMastsInTheClearSpaceOfATrack) {
  scene::Chunk chunk;
  chunk.roads = {way_along(kMainStreet, {{0, 50}, {120, 50}}, LandCoverClass::kRailway, 3)};
  chunk.things = {
      {.id = {kMainStreet, kFirstDerivedPart + 1},
       .at = {40, 53},
       .form = {.kind = std::string(map::name_of(map::ThingRole::kContactMast)), .width_m = 0.5, .depth_m = 0.5}}};
  const std::vector<ground::LandCoverPolygon> none;
  const ground::LandCoverIndex index = ground::index_land_cover(none, kTile);
  const auto measured = [&] { return measure_assumed_masts(chunk, index, kTile); };
  EXPECT_EQ(measured().tested, 1u);
  EXPECT_EQ(measured().conflicts, 0u);
  chunk.things[0].at.y = 52;
  EXPECT_EQ(measured().conflicts, 1u);
  // the feet of a portal are half its width beside its middle
  chunk.things[0].form.kind = map::name_of(map::ThingRole::kContactPortal), chunk.things[0].at = {40, 50};
  chunk.things[0].direction = 0, chunk.things[0].form.width_m = 8;
  EXPECT_EQ(measured().tested, 2u);
  EXPECT_EQ(measured().conflicts, 0u);
  chunk.things[0].form.width_m = 4;
  EXPECT_EQ(measured().conflicts, 2u);
  chunk.things[0].id.part = 0;
  EXPECT_EQ(measured().tested, 0u) << "mapped masts are not tested";
}

// A lawn of a yard with a tree of it at a place.
scene::Chunk yard_with_tree(Vec2 at) {
  scene::Chunk chunk;
  chunk.surfaces = {
      {{kMainStreet, kFirstDerivedPart}, LandCoverClass::kLawn, 6400, {{{20, 20}, {100, 20}, {100, 100}, {20, 100}}}}};
  chunk.trees = {{.id = {kMainStreet, kFirstDerivedPart}, .at = at}};
  return chunk;
}

AssumedTests yards_of(const scene::Chunk& chunk) {
  const ground::LandCoverIndex cover = ground::index_land_cover(chunk.surfaces, kTile);
  return measure_assumed_yards(chunk, cover, kTile);
}

TEST(MeasureAssumed, FindsTreesOfYardsInRoadsBarriersAndBelowWires) {
  scene::Chunk chunk = yard_with_tree({50, 50});
  EXPECT_EQ(yards_of(chunk).tested, 401u);
  EXPECT_EQ(yards_of(chunk).conflicts, 0u);
  chunk.barriers = {{.id = {kMappedWay, 0}, .axis = {{40, 50.2}, {60, 50.2}}, .width_m = 0.25}};
  EXPECT_EQ(yards_of(chunk).obstacle, kMappedWay);
  chunk.barriers.clear();
  chunk.corridors = {{{kMappedWay, 0}, {{0, 55}, {120, 55}}, 12}};
  EXPECT_EQ(yards_of(chunk).conflicts, 1u);
  chunk.corridors.clear();
  chunk.surfaces.push_back(
      {{kMappedWay, 0}, LandCoverClass::kResidentialRoad, 1, {{{0, 47}, {120, 47}, {120, 53}, {0, 53}}}});
  EXPECT_EQ(yards_of(chunk).conflicts, 1u);
}

TEST(MeasureAssumed, FindsYardsOverMappedLand) {
  scene::Chunk chunk = yard_with_tree({50, 50});
  const std::vector<Ring> part = {{{60, 60}, {80, 60}, {80, 80}, {60, 80}}};
  chunk.surfaces.push_back({{kMappedWay, 0}, LandCoverClass::kGarden, 400, part});
  EXPECT_EQ(yards_of(chunk).conflicts, 0u);
  chunk.surfaces.back().surface = LandCoverClass::kAerodrome;  // of a lower priority
  EXPECT_EQ(yards_of(chunk).conflicts, 25u);
  chunk.surfaces.back().surface = LandCoverClass::kRetail;
  EXPECT_EQ(yards_of(chunk).conflicts, 0u);
}

TEST(MeasureAssumed, FindsHousesOfLotsOnRoadsAndOtherBuildings) {
  scene::Chunk chunk;
  buildings::Building house;
  house.id = {{OsmType::kLot, 7}, 0};
  house.footprint.outer = {{40, 40}, {50, 40}, {50, 50}, {40, 50}};
  chunk.buildings = {house};
  const auto measured = [&] {
    return measure_assumed_houses(chunk, ground::index_land_cover(chunk.surfaces, kTile), kTile);
  };
  EXPECT_EQ(measured().tested, 8u);
  EXPECT_EQ(measured().conflicts, 0u);
  chunk.surfaces = {{{kMappedWay, 0}, LandCoverClass::kResidentialRoad, 1, {{{0, 47}, {120, 47}, {120, 53}, {0, 53}}}}};
  EXPECT_EQ(measured().obstacle, kMappedWay);
  EXPECT_EQ(measured().conflicts, 3u);
  chunk.surfaces.clear();
  house.id = {kMainStreet, 0};
  house.footprint.outer = {{44, 35}, {60, 35}, {60, 47}, {44, 47}};
  chunk.buildings.push_back(house);
  EXPECT_EQ(measured().conflicts, 3u) << "a corner and the middles of two walls";
  chunk.buildings.back().id = {{OsmType::kLot, 7}, 1};
  EXPECT_EQ(measured().conflicts, 0u) << "of the same lot";
}

}  // namespace
}  // namespace citykiln::verify

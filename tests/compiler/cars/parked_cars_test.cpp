#include "compiler/cars/parked_cars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/map/things/thing_role.h"
#include "compiler/roads/pieces/stretches.h"
#include "tests/compiler/cars/made_street.h"

namespace citykiln::cars {
namespace {

using map::LandCoverClass;

Box2 box_between(double from_x, double to_x) { return {{from_x, -128}, {to_x, 128}}; }

double distance_m(const Place& place, Vec2 p) {
  const auto corners = corners_of(rect_of(place));
  return distance_to_ring(corners, p);
}

TEST(ParkedCars, StandAtTheKerbOfAStreetBetweenHouses) {
  const std::vector<Place> places = street_tile().places(kMadeBox);
  EXPECT_GT(places.size(), 40u);
  for (const Place& place : places) {
    EXPECT_EQ(place.kind, PlaceKind::kKerb);
    EXPECT_EQ(place.at.y, -2.5);
    EXPECT_EQ(place.ahead, (Vec2{1, 0})) << "they look along the traffic";
  }
}

TEST(ParkedCars, StandAtNoKerbInOpenLand) {
  MadeTile tile = street_tile();
  tile.cover.pop_back();
  EXPECT_TRUE(tile.places(kMadeBox).empty());
}

TEST(ParkedCars, StandInParkingLanesInOpenLandToo) {
  MadeTile tile = street_tile();
  tile.cover.pop_back();
  tile.roads[0].section.lanes[1].width_m = 1.5;
  tile.roads[0].section.lanes.push_back({map::LaneKind::kParking, map::LaneDirection::kForward, 2});
  tile.roads[0].kerb_parking = 0;
  const std::vector<Place> places = tile.places(kMadeBox);
  EXPECT_GT(places.size(), 40u);
  for (const Place& place : places) {
    EXPECT_EQ(place.kind, PlaceKind::kLane);
    EXPECT_EQ(place.at.y, -2.5);
  }
}

TEST(ParkedCars, StandInNoCarriagewayWithRails) {
  MadeTile tile = street_tile();
  tile.cover.push_back(made_cover(9, {{0, 1}, {125, 3}}, LandCoverClass::kTram));
  const std::vector<Place> places = tile.places(kMadeBox);
  EXPECT_FALSE(places.empty());
  for (const Place& place : places) EXPECT_GT(place.at.x, 125 - 3);
}

TEST(ParkedCars, KeepOffWhatReachesIntoTheSideOfAPlace) {
  const auto is_beside_it = [](const Place& place) { return std::abs(place.at.x - 8.625) < 2; };
  MadeTile tile = street_tile();
  EXPECT_TRUE(std::ranges::any_of(tile.places(kMadeBox), is_beside_it));
  // between the corners of the place from 5.75 m to 11.5 m
  tile.cover.push_back(made_cover(9, {{7.9, -3.5}, {9.1, -3}}, LandCoverClass::kBuilding));
  EXPECT_TRUE(std::ranges::none_of(tile.places(kMadeBox), is_beside_it));
}

TEST(ParkedCars, KeepOffWhatReachesBetweenTheTestedPoints) {
  MadeTile tile = street_tile();
  // 7 points along each place of 5.75 m, from 0.25 m on
  std::int64_t id = 100;
  for (double from_m = 0; from_m < 230; from_m += 5.75)
    for (const int i : {0, 1, 4, 5}) {
      const double x = from_m + 0.25 + (i + 0.5) * 5.25 / 6;
      tile.cover.push_back(made_cover(id++, {{x - 0.4, -3.5}, {x + 0.4, -2.9}}, LandCoverClass::kBuilding));
    }
  const std::vector<things::Thing> cars = tile.cars(kMadeBox, CarShare{1});
  EXPECT_FALSE(tile.places(kMadeBox).empty());
  for (const things::Thing& car : cars) {
    OrientedRect inner = roadside::plan_of(car);
    inner.length_m -= 0.625, inner.width_m -= 0.625;
    for (const Vec2 p : corners_of(inner))
      for (std::size_t i = 2; i < tile.cover.size(); ++i) {
        const Ring& path = tile.cover[i].rings.front();
        EXPECT_FALSE((Box2{path[0], path[2]}.contains(p))) << p.x << ", " << p.y;
      }
  }
}

TEST(ParkedCars, AreEachInOneTile) {
  const MadeTile tile = street_tile();
  const std::vector<Place> whole = tile.places(box_between(0, 256));
  std::vector<Place> parts;
  for (double x = 0; x < 256; x += 16)
    for (const Place& place : tile.places(box_between(x, x + 16))) parts.push_back(place);
  const auto keys = [](const std::vector<Place>& places) {
    std::vector<StableId> all;
    for (const Place& place : places) all.push_back(place.key);
    std::ranges::sort(all);
    return all;
  };
  EXPECT_EQ(keys(parts), keys(whole));
}

TEST(ParkedCars, OfAPartOfAStreetAreThoseOfTheWhole) {
  MadeTile part = street_tile();
  part.roads[0].axis = {{100, 0}, {250, 0}};
  part.roads[0].start_along_m = 100;
  const std::vector<Place> whole = street_tile().places(kMadeBox);
  const std::vector<Place> places = part.places(kMadeBox);
  EXPECT_GT(places.size(), 20u);
  for (const Place& place : places)
    EXPECT_TRUE(std::ranges::any_of(whole, [&](const Place& o) { return o.key == place.key && o.at == place.at; }));
}

TEST(ParkedCars, NoTwoOverlap) {
  MadeTile tile = street_tile();
  // a second street joins at a flat angle, and both are one surface
  tile.roads.push_back(made_street(17, {{0, -20}, {250, 10}}));
  for (roads::Road& road : tile.roads) {
    road.kerb_parking = 0;
    road.section.lanes[1].width_m = 1.5;
    road.section.lanes.push_back({map::LaneKind::kParking, map::LaneDirection::kForward, 2});
  }
  tile.cover = {made_cover(7, {{0, -30}, {250, 30}}, LandCoverClass::kResidentialRoad),
                made_cover(8, {{0, -45}, {250, -30}}, LandCoverClass::kBuilding)};
  const std::vector<Place> places = tile.places(kMadeBox);
  EXPECT_GT(places.size(), 50u);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      EXPECT_GT(distance(places[i].at, places[j].at), 1.8);
      for (const Vec2 corner : corners_of(rect_of(places[i]))) {
        const Vec2 d = corner - places[j].at;
        const bool is_in = std::abs(dot(d, places[j].ahead)) < places[j].length_m / 2 - 0.1 &&
                           std::abs(cross(d, places[j].ahead)) < places[j].width_m / 2 - 0.1;
        EXPECT_FALSE(is_in);
      }
    }
}

TEST(ParkedCars, StandFiveMetresFromCrossings) {
  MadeTile tile = street_tile();
  tile.roads[0].axis = {{0, 0}, {120, 0}, {250, 0}};
  tile.roads[0].points = {{.vertex = 1, .kind = map::TrackPointKind::kZebra}};
  const std::size_t before = street_tile().places(kMadeBox).size();
  const std::vector<Place> places = tile.places(kMadeBox);
  EXPECT_LT(places.size(), before);
  EXPECT_GT(places.size() + 5, before);
  // the crossing is 4 m wide
  for (const Place& place : places)
    EXPECT_GE(std::abs(place.at.x - 120) - place.length_m / 2, 2 + roadside::kFromCrossing_m - 1) << place.at.x;
}

TEST(ParkedCars, StandFiveMetresFromJunctions) {
  MadeTile tile = street_tile();
  tile.roads[0].axis = {{0, 0}, {120, 0}, {250, 0}};
  tile.roads.push_back(made_street(8, {{120, 0}, {120, 100}}));
  Report report;
  tile.junctions = roads::plan_junctions(tile.roads, report);
  ASSERT_EQ(tile.junctions.size(), 1u);
  const std::vector<Place> places = tile.places(kMadeBox);
  EXPECT_GT(places.size(), 20u);
  // the mouth of the side street is 7 m wide, and its corners are rounded
  for (const Place& place : places)
    if (place.feature.id == 7) {
      EXPECT_GE(std::abs(place.at.x - 120) - place.length_m / 2, 3.5 + roadside::kFromJunction_m - 1) << place.at.x;
    }
}

TEST(ParkedCars, StandTenMetresFromStops) {
  MadeTile tile = street_tile();
  tile.things = {{.id = {{OsmType::kNode, 3}, 0}, .at = {100, -5}, .form = {.kind = "bus_stop"}}};
  const std::vector<Place> places = tile.places(kMadeBox);
  EXPECT_FALSE(places.empty());
  for (const Place& place : places) EXPECT_GE(distance_m(place, {100, -5}), roadside::kFromStop_m - 0.5);
}

TEST(ParkedCars, LeaveDrivesFree) {
  MadeTile tile = street_tile();
  lots::Yard yard;
  yard.building = {{OsmType::kWay, 8}, 0};
  yard.frame = lots::place_of({.origin = {80, -5}, .along = {-1, 0}, .inward = {0, -1}});
  yard.strips = {{.is_drive = true, .from = {0, 0}, .to = {0, 7}}};
  tile.yards = {yard};
  tile.cover.push_back(made_cover(9, {{78, -12}, {82, -5}}, LandCoverClass::kAsphaltDrive));
  const std::vector<Place> places = tile.places(kMadeBox);
  EXPECT_EQ(std::ranges::count(places, PlaceKind::kDrive, &Place::kind), 1);
  for (const Place& place : places)
    if (place.kind == PlaceKind::kKerb) {
      EXPECT_GT(std::abs(place.at.x - 80) - place.length_m / 2, 1.25) << place.at.x;
    }
}

// A mapped parking space of 2 by 5 m, along the x axis.
things::Thing space_at(Vec2 at) {
  return {.id = {{OsmType::kNode, 3}, 0}, .at = at, .form = {.kind = std::string(map::name_of(map::ThingRole::kCar))}};
}

TEST(ParkedCars, OfNeighbouringTilesDoNotOverlapAtMappedSpaces) {
  MadeTile west = street_tile();
  west.things = {space_at({97, -2.5})};
  MadeTile east = street_tile();
  std::size_t spaces = 0;
  for (double border_x = 97.5; border_x < 103; border_x += 0.5) {
    const std::vector<Place> in_west = west.places(box_between(-64, border_x)),
                             in_east = east.places(box_between(border_x, 320));
    spaces += static_cast<std::size_t>(std::ranges::count(in_west, PlaceKind::kSpace, &Place::kind));
    for (const Place& a : in_west) {
      for (const Place& b : in_east) EXPECT_FALSE(overlap(rect_of(a), rect_of(b), 0.0625)) << border_x;
      for (const Place& b : in_west)
        EXPECT_TRUE(a.key == b.key || !overlap(rect_of(a), rect_of(b), 0.0625)) << border_x;
    }
  }
  EXPECT_GT(spaces, 3u) << "a space counts before places of its own tile";
}

TEST(ParkedCars, KeepOffAllOfAThingButDriveOverLowOnes) {
  const auto is_beside_it = [](const Place& place) { return std::abs(place.at.x - 100.625) < 2; };
  MadeTile tile = street_tile();
  ASSERT_TRUE(std::ranges::any_of(tile.places(kMadeBox), is_beside_it));
  // 3 m long across the kerb, with its middle on the pavement
  tile.things = {{.id = {{OsmType::kNode, 3}, 0},
                  .at = {100.625, -4.5},
                  .direction = 0,
                  .form = {.kind = "bicycle_parking", .width_m = 3, .depth_m = 0.8, .height_m = 0.85}}};
  EXPECT_TRUE(std::ranges::none_of(tile.places(kMadeBox), is_beside_it));
  tile.things[0].form.height_m = 0.02;
  EXPECT_TRUE(std::ranges::any_of(tile.places(kMadeBox), is_beside_it));
}

TEST(ParkedCars, KeepOffTrunks) {
  MadeTile tile = street_tile();
  tile.trunks = {{100, -2.5}};
  for (const Place& place : tile.places(kMadeBox)) EXPECT_GT(std::abs(place.at.x - 100), place.length_m / 2);
}

TEST(ParkedCars, AtKerbsLeaveThreeMetresBesideAParkingLane) {
  const auto at_kerb = [](double driving_m) {
    MadeTile tile = street_tile();
    roads::Road& road = tile.roads[0];
    road.section.lanes = {{map::LaneKind::kParking, map::LaneDirection::kBackward, 2},
                          {map::LaneKind::kDriving, map::LaneDirection::kBackward, driving_m / 2},
                          {map::LaneKind::kDriving, map::LaneDirection::kForward, driving_m / 2}};
    road.section.axis_offset_m = 3.5;
    return std::ranges::count(tile.places(kMadeBox), PlaceKind::kKerb, &Place::kind);
  };
  EXPECT_EQ(at_kerb(4.75), 0);
  EXPECT_GT(at_kerb(5), 20);
}

TEST(ParkedCars, StandAtTheMappedPlaceOfACrossingThatIsPaintedElsewhere) {
  MadeTile tile = street_tile();
  // the side street's mouth is wide, so the crossing moves away from its node
  tile.roads[0].axis = {{0, 0}, {120, 0}, {124, 0}, {250, 0}};
  tile.roads[0].points = {{.vertex = 2, .kind = map::TrackPointKind::kZebra}};
  tile.roads.push_back(made_street(8, {{120, 0}, {120, 100}}));
  Report report;
  tile.junctions = roads::plan_junctions(tile.roads, report);
  const auto intervals = roads::junction_intervals_of(tile.roads, tile.junctions);
  double painted_to_m = 0;
  for (const roads::RoadStretch& stretch : roads::stretches_of(tile.roads[0], intervals[0], 256))
    if (stretch.stretch == roads::StretchKind::kZebra) painted_to_m = stretch.to_m;
  ASSERT_GT(painted_to_m, 124);
  double nearest_m = 1000;
  for (const Place& place : tile.places(kMadeBox))
    if (place.at.x > 124) nearest_m = std::min(nearest_m, place.at.x - place.length_m / 2);
  EXPECT_GE(nearest_m, painted_to_m + roadside::kFromCrossing_m - 1);
}

TEST(ParkedCars, StandInMappedSpacesWhichAreNoCarsThemselves) {
  MadeTile tile = street_tile();
  tile.things = {space_at({100, 20})};
  EXPECT_EQ(std::ranges::count(tile.places(kMadeBox), PlaceKind::kSpace, &Place::kind), 1);
}

TEST(ParkedCars, AreAShareOfThePlaces) {
  const MadeTile tile = street_tile();
  const std::size_t places = tile.places(kMadeBox).size();
  EXPECT_EQ(tile.cars(kMadeBox, {.share = 1}).size(), places);
  EXPECT_TRUE(tile.cars(kMadeBox, kNoCars).empty());
  const std::size_t half = tile.cars(kMadeBox, {.share = 0.5}).size();
  EXPECT_GT(half, places / 4);
  EXPECT_LT(half, places * 3 / 4);
}

TEST(ParkedCars, StandWithinTheirPlaces) {
  const MadeTile tile = street_tile();
  const std::vector<Place> places = tile.places(kMadeBox);
  std::size_t widest = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<things::Thing> cars = tile.cars(kMadeBox, {.share = 1}, seed);
    ASSERT_EQ(cars.size(), places.size());
    for (std::size_t i = 0; i < cars.size(); ++i) {
      EXPECT_EQ(cars[i].form.kind, "car");
      EXPECT_FALSE(cars[i].form.value.empty());
      widest += cars[i].form.width_m > 1.9;
      for (const Vec2 corner : corners_of(roadside::plan_of(cars[i]))) {
        const Vec2 off = corner - places[i].at;
        EXPECT_LE(std::abs(dot(off, places[i].ahead)), places[i].length_m / 2 + 0.01);
        EXPECT_LE(std::abs(cross(off, places[i].ahead)), places[i].width_m / 2 + 0.01);
      }
    }
  }
  EXPECT_GT(widest, 20u) << "minibuses and pickups are among them";
}

TEST(ParkedCars, DependOnTheSeed) {
  const MadeTile tile = street_tile();
  EXPECT_EQ(tile.cars(kMadeBox, {.share = 0.5}, 1), tile.cars(kMadeBox, {.share = 0.5}, 1));
  EXPECT_NE(tile.cars(kMadeBox, {.share = 0.5}, 1), tile.cars(kMadeBox, {.share = 0.5}, 2));
}

// A plot of 24 by 22 m that is a car park on the land use w3.
MadeTile tile_with_plot() {
  MadeTile tile;
  lots::Yard plot{.building = {{OsmType::kWay, 3}, 1}, .kind = lots::LotKind::kCarPark};
  plot.polygon.outer = {{0, 10}, {24, 10}, {24, 32}, {0, 32}};
  tile.plots = {plot};
  tile.cover = {made_cover(3, {{-50, 0}, {20, 50}}, LandCoverClass::kCommercial)};
  return tile;
}

TEST(ParkedCars, OnPlotsStandOnTheLandUseOfTheirPlotAndOnUnmappedLand) {
  MadeTile tile = tile_with_plot();
  EXPECT_EQ(tile.places(kMadeBox).size(), 14u) << "two rows, also beyond x = 20";
  // land use that lies above the paving
  for (const LandCoverClass other : {LandCoverClass::kInstitution, LandCoverClass::kBrownfield}) {
    tile = tile_with_plot();
    tile.cover.push_back(made_cover(4, {{0, 10}, {9, 20}}, other));
    EXPECT_EQ(tile.places(kMadeBox).size(), 11u);
    for (const Place& place : tile.places(kMadeBox)) EXPECT_TRUE(place.at.y > 20 || place.at.x > 9);
  }
}

// A shop whose wall stands at the kerb, from x = 100 to 110, with a door in its middle.
TEST(ParkedCars, KeepOffDoors) {
  MadeTile tile = street_tile();
  buildings::Building shop{.id = {{OsmType::kWay, 50}, 0}};
  shop.footprint.outer = {{100, -10}, {110, -10}, {110, -3.5}, {100, -3.5}};
  shop.facade_edges.resize(4);
  shop.facade_edges[2].doors = 1 << 7;
  const Vec2 door = {105.3, -3.5};
  const auto is_before_it = [&](const Place& place) { return distance_m(place, door) < 1; };
  EXPECT_TRUE(std::ranges::any_of(tile.places(kMadeBox), is_before_it));
  tile.buildings = {shop};
  EXPECT_FALSE(tile.places(kMadeBox).empty());
  EXPECT_TRUE(std::ranges::none_of(tile.places(kMadeBox), is_before_it));
}

TEST(ParkedCars, KeepOffBarriers) {
  MadeTile tile = street_tile();
  const auto is_across = [](const Place& place) { return std::abs(place.at.x - 100) < place.length_m / 2; };
  EXPECT_TRUE(std::ranges::any_of(tile.places(kMadeBox), is_across));
  tile.barriers = {{.id = {{OsmType::kWay, 51}, 0}, .axis = {{100, -6}, {100, -2}}, .kind = map::BarrierKind::kWall}};
  EXPECT_TRUE(std::ranges::none_of(tile.places(kMadeBox), is_across));
}

}  // namespace
}  // namespace citykiln::cars

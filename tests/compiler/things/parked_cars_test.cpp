#include "compiler/things/parked_cars.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::things {
namespace {

using map::LandCoverClass;
using map::LaneDirection;
using map::LaneKind;

ground::LandCoverPolygon cover_rectangle(std::int64_t id, Vec2 low, Vec2 high, LandCoverClass surface) {
  ground::LandCoverPolygon polygon;
  polygon.id = {{OsmType::kWay, id}, 0};
  polygon.surface = surface;
  polygon.rings = {{low, {high.x, low.y}, high, {low.x, high.y}}};
  return polygon;
}

// A street along x with a parking lane on its right, of 2 m, from y = -5 to -3.
roads::Road parking_street() {
  roads::Road road;
  road.id = {{OsmType::kWay, 7}, 0};
  road.axis = {{0, 0}, {300, 0}};
  road.surface = LandCoverClass::kResidentialRoad;
  road.section.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, 3},
                        {LaneKind::kDriving, LaneDirection::kForward, 3},
                        {LaneKind::kParking, LaneDirection::kForward, 2}};
  road.section.axis_offset_m = 3;
  return road;
}

std::vector<ground::LandCoverPolygon> cover_of_street() {
  return {cover_rectangle(1, {0, -3}, {300, 3}, LandCoverClass::kResidentialRoad),
          cover_rectangle(2, {0, -5}, {200, -3}, LandCoverClass::kParkingLane)};
}

std::vector<map::ThingFeature> cars_in_street(std::uint64_t seed) {
  const auto cover = cover_of_street();
  FreePlaces places(cover);
  const std::vector<roads::Road> roads = {parking_street()};
  return parked_cars({}, map::Features{}, roads, places, seed);
}

TEST(ParkedCars, StandInTheParkingLane) {
  const auto cars = cars_in_street(1);
  EXPECT_GT(cars.size(), 34 * kOccupied * 0.7);
  EXPECT_LT(cars.size(), 34 * kOccupied * 1.3);
  for (const map::ThingFeature& car : cars) {
    EXPECT_EQ(car.at.y, -4);
    EXPECT_LT(car.at.x + car.depth_m / 2, 200) << "the lane ends there";
    EXPECT_EQ(car.id.osm.id, 7);
    EXPECT_EQ(car.faces, (Vec2{1, 0})) << "it looks along the traffic of its lane";
  }
  for (std::size_t i = 1; i < cars.size(); ++i) EXPECT_GT(cars[i].at.x - cars[i - 1].at.x, cars[i].depth_m);
}

TEST(ParkedCars, DependOnTheSeed) {
  const auto positions = [](const std::vector<map::ThingFeature>& cars) {
    std::vector<Vec2> at;
    for (const map::ThingFeature& car : cars) at.push_back(car.at);
    return at;
  };
  EXPECT_EQ(positions(cars_in_street(1)), positions(cars_in_street(1)));
  EXPECT_NE(positions(cars_in_street(1)), positions(cars_in_street(2)));
}

TEST(ParkedCars, APartOfAStreetHasTheCarsOfTheWhole) {
  const auto cover = cover_of_street();
  FreePlaces places(cover);
  std::vector<roads::Road> part = {parking_street()};
  part[0].axis = {{100, 0}, {300, 0}};
  part[0].start_along_m = 100;
  const auto whole = cars_in_street(1);
  for (const map::ThingFeature& car : parked_cars({}, map::Features{}, part, places, 1))
    EXPECT_EQ(std::ranges::count_if(whole, [&](const auto& other) { return other.id == car.id && other.at == car.at; }),
              1);
}

TEST(ParkedCars, StandInRowsOnACarPark) {
  map::Features features;
  map::AreaFeature area;
  area.id = {{OsmType::kWay, 9}, 0};
  area.surface = LandCoverClass::kParking;
  area.polygon.outer = {{0, 0}, {52, 0}, {52, 16}, {0, 16}};
  features.areas = {area};
  const std::vector<ground::LandCoverPolygon> cover = {cover_rectangle(9, {0, 0}, {52, 16}, LandCoverClass::kParking)};
  FreePlaces places(cover);
  const auto cars = parked_cars({}, features, {}, places, 1);
  EXPECT_GT(cars.size(), 40 * kOccupied * 0.7);
  for (const map::ThingFeature& car : cars) {
    EXPECT_TRUE(car.at.y == 2.5 || car.at.y == 13.5) << car.at.y;
    EXPECT_EQ(std::abs(car.faces->y), 1) << "across the lane";
  }
}

}  // namespace
}  // namespace citykiln::things

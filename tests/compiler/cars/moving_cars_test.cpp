#include "compiler/cars/moving_cars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/map/things/thing_role.h"
#include "compiler/things/facing.h"
#include "tests/compiler/cars/made_street.h"

namespace citykiln::cars {
namespace {

using map::LandCoverClass;

constexpr CarShare kEverySlot{.share = 1};

// A primary road of two lanes along y = 0 from x = 0 to 250, without parked cars.
MadeTile primary_road() {
  MadeTile tile = street_tile();
  tile.roads[0].surface = tile.cover[0].surface = LandCoverClass::kPrimaryRoad;
  tile.roads[0].kerb_parking = 0;
  return tile;
}

TEST(MovingCars, StandInTheMiddleOfTheirLanesAndLookAlongThem) {
  const std::vector<things::Thing> cars = primary_road().traffic(kMadeBox, kEverySlot);
  EXPECT_GT(cars.size(), 30u);
  for (const things::Thing& car : cars) {
    const bool is_forward = things::unit_vector(car.direction).x > 0;
    EXPECT_NEAR(car.at.y, is_forward ? -1.75 : 1.75, 0.01) << "one drives on the right";
  }
}

TEST(MovingCars, DriveOnTheLeftWhereLanesHaveBothDirections) {
  MadeTile tile = primary_road();
  tile.roads[0].side = map::DrivingSide::kLeft;
  tile.roads[0].section.lanes = {{map::LaneKind::kDriving, map::LaneDirection::kBoth, 7}};
  const std::vector<things::Thing> cars = tile.traffic(kMadeBox, kEverySlot);
  EXPECT_GT(cars.size(), 30u);
  for (const things::Thing& car : cars)
    EXPECT_NEAR(car.at.y, things::unit_vector(car.direction).x > 0 ? 1.75 : -1.75, 0.01);
}

TEST(MovingCars, LeaveNarrowStreetsToOneDirection) {
  MadeTile tile = street_tile();
  tile.roads[0].section.lanes = {{map::LaneKind::kDriving, map::LaneDirection::kBoth, 3.5}};
  tile.roads[0].section.axis_offset_m = 1.75;
  tile.roads[0].kerb_parking = 0;
  const std::vector<things::Thing> cars = tile.traffic(kMadeBox, kEverySlot);
  ASSERT_GT(cars.size(), 10u);
  for (const things::Thing& car : cars) {
    EXPECT_EQ(car.direction, cars.front().direction);
    EXPECT_NEAR(car.at.y, 0, 0.01);
  }
}

TEST(MovingCars, OverlapNeitherEachOtherNorParkedCars) {
  const MadeTile tile = street_tile();
  std::vector<things::Thing> all = tile.traffic(kMadeBox, kEverySlot, {.share = 1});
  EXPECT_GT(all.size(), 20u);
  std::ranges::copy(tile.cars(kMadeBox, {.share = 1}), std::back_inserter(all));
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(roadside::plan_of(all[i]), roadside::plan_of(all[k]), 0));
}

TEST(MovingCars, KeepOffMappedSpacesInTheirLane) {
  MadeTile tile = street_tile();
  tile.roads[0].kerb_parking = 0;
  for (int i = 0; i < 12; ++i)
    tile.things.push_back(
        {.id = {{OsmType::kNode, 60 + i}, 0},
         .at = {20.0 * i + 10, 1.75},
         .form = {.kind = std::string(map::name_of(map::ThingRole::kCar)), .width_m = 2, .depth_m = 5}});
  const std::vector<things::Thing> moving = tile.traffic(kMadeBox, kEverySlot, {.share = 1});
  EXPECT_FALSE(moving.empty());
  const std::vector<things::Thing> parked = tile.cars(kMadeBox, {.share = 1});
  EXPECT_EQ(parked.size(), 12u);
  for (const things::Thing& car : moving)
    for (const things::Thing& other : parked)
      EXPECT_FALSE(overlap(roadside::plan_of(car), roadside::plan_of(other), 0));
}

TEST(MovingCars, StandOnNoRailsAndNoOtherGround) {
  MadeTile tile = primary_road();
  tile.cover.push_back(made_cover(9, {{100, -10}, {120, 10}}, LandCoverClass::kTram));
  const std::vector<things::Thing> cars = tile.traffic(kMadeBox, kEverySlot);
  EXPECT_FALSE(cars.empty());
  for (const things::Thing& car : cars)
    EXPECT_TRUE(car.at.x + car.form.depth_m / 2 < 100.3 || car.at.x - car.form.depth_m / 2 > 119.7) << car.at.x;
}

TEST(MovingCars, KeepOffLevelCrossings) {
  MadeTile tile = primary_road();
  tile.roads[0].axis = {{0, 0}, {100, 0}, {250, 0}};
  tile.roads[0].points = {{1, map::TrackPointKind::kLevelCrossing, 0, 0}};
  for (const things::Thing& car : tile.traffic(kMadeBox, kEverySlot))
    EXPECT_GT(std::abs(car.at.x - 100), 8 + car.form.depth_m / 2 - 1);
}

TEST(MovingCars, AreEachInOneTile) {
  const MadeTile tile = primary_road();
  std::size_t parts = 0;
  for (double x = 0; x < 256; x += 16) parts += tile.traffic({{x, -128}, {x + 16, 128}}, kEverySlot).size();
  EXPECT_EQ(parts, tile.traffic({{0, -128}, {256, 128}}, kEverySlot).size());
}

TEST(MovingCars, AreAShareOfTheSlots) {
  const MadeTile tile = primary_road();
  EXPECT_TRUE(tile.traffic(kMadeBox, kNoCars).empty());
  EXPECT_LT(tile.traffic(kMadeBox, {.share = 0.25}).size(), tile.traffic(kMadeBox, kEverySlot).size() / 2);
  EXPECT_LT(traffic_share({3}), 0.15);
  EXPECT_GT(traffic_share({18}), 0.9);
}

TEST(MovingCars, HaveLorriesAndBusesOnMainRoads) {
  std::size_t buses = 0, lorries = 0;
  for (std::int64_t id = 0; id < 20; ++id) {
    MadeTile tile = primary_road();
    tile.roads[0].id.osm.id = 100 + id;
    for (const things::Thing& car : tile.traffic(kMadeBox, kEverySlot))
      buses += car.form.value == "bus", lorries += car.form.value == "lorry";
  }
  EXPECT_GT(buses, 10u);
  EXPECT_GT(lorries, 10u);
}

}  // namespace
}  // namespace citykiln::cars

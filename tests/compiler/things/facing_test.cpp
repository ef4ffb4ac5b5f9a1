#include "compiler/things/facing.h"

#include <gtest/gtest.h>

#include "compiler/geometry/trig.h"

namespace citykiln::things {
namespace {

roads::Road street(Polyline axis) {
  return {.id = {{OsmType::kWay, 1}, 0}, .axis = std::move(axis), .surface = map::LandCoverClass::kResidentialRoad};
}

map::ThingFeature thing_on_way(bool is_oneway, bool is_nearer_to_end, std::int8_t facing = 0) {
  map::ThingFeature thing{.id = {{OsmType::kNode, 2}, 0}, .at = {10, 0}};
  thing.facing = facing;
  thing.way = {.id = {{OsmType::kWay, 1}, 0}, .along = {1, 0}, .is_oneway = is_oneway};
  thing.way.is_nearer_to_end = is_nearer_to_end;
  return thing;
}

TEST(Facing, TheNearestDirectionIsWithinHalfAStep) {
  for (int i = 0; i < 5000; ++i) {
    const Vec2 v = citykiln::direction_of(i / 5000.0);
    const std::uint16_t direction = nearest_direction(v * (0.1 + i));
    ASSERT_LT(direction, kDirections);
    EXPECT_LT(distance(unit_vector(direction), v), 3.15 / kDirections) << i;
  }
  for (std::uint16_t d = 0; d < kDirections; ++d) EXPECT_EQ(nearest_direction(unit_vector(d)), d);
  EXPECT_EQ(nearest_direction({}), 0);
}

TEST(Facing, ABearingIsClockwiseOfNorth) {
  map::ThingFeature thing{.id = {{OsmType::kNode, 2}, 0}, .at = {}};
  const Axes none = axes_of({});
  const std::pair<double, Vec2> cases[] = {{0, {0, 1}}, {90, {1, 0}}, {180, {0, -1}}, {270, {-1, 0}}};
  for (const auto& [bearing_deg, expected] : cases) {
    thing.bearing_deg = bearing_deg;
    EXPECT_LT(distance(facing_of(thing, map::Facing::kStreet, {}, none, 0), expected), 1e-12) << bearing_deg;
  }
}

TEST(Facing, ABenchLooksAtTheStreetWithin30Metres) {
  const roads::Road road = street({{-100, 0}, {100, 0}});
  const Axes axes = axes_of(std::span(&road, 1));
  const map::ThingFeature thing{.id = {{OsmType::kNode, 2}, 0}, .at = {5, 8}};
  EXPECT_EQ(facing_of(thing, map::Facing::kStreet, {5, 8}, axes, 0), (Vec2{0, -1}));
  EXPECT_EQ(facing_of(thing, map::Facing::kStreet, {5, -8}, axes, 0), (Vec2{0, 1}));
  EXPECT_EQ(facing_of(thing, map::Facing::kStreet, {5, 31}, axes, 0), (Vec2{0, -1})) << "south";
}

TEST(Facing, ASignLooksAtTheTrafficThatItIsFor) {
  const Axes none = axes_of({});
  const auto looks = [&](const map::ThingFeature& thing) { return facing_of(thing, map::Facing::kAlong, {}, none, 0); };
  EXPECT_EQ(looks(thing_on_way(false, false, 1)), (Vec2{-1, 0}));
  EXPECT_EQ(looks(thing_on_way(false, true, -1)), (Vec2{1, 0}));
  EXPECT_EQ(looks(thing_on_way(true, false)), (Vec2{-1, 0})) << "traffic of a oneway";
  EXPECT_EQ(looks(thing_on_way(false, true)), (Vec2{-1, 0})) << "traffic towards the near end";
  EXPECT_EQ(looks(thing_on_way(false, false)), (Vec2{1, 0}));
}

TEST(Facing, BesideAStreetASignLooksAtTheTrafficOfItsSide) {
  roads::Road road = street({{-100, 0}, {100, 0}});
  const map::ThingFeature thing{.id = {{OsmType::kNode, 2}, 0}, .at = {}};
  const auto looks_from = [&](Vec2 p) {
    return facing_of(thing, map::Facing::kAlong, p, axes_of(std::span(&road, 1)), 0);
  };
  road.side = map::DrivingSide::kRight;
  EXPECT_EQ(looks_from({0, -5}), (Vec2{-1, 0}));
  EXPECT_EQ(looks_from({0, 5}), (Vec2{1, 0}));
  road.side = map::DrivingSide::kLeft;
  EXPECT_EQ(looks_from({0, -5}), (Vec2{1, 0}));
}

}  // namespace
}  // namespace citykiln::things

#include "compiler/roadside/clear_zones.h"

#include <gtest/gtest.h>

#include "compiler/map/things/thing_role.h"

namespace citykiln::roadside {
namespace {

things::Thing thing_at(Vec2 at, double height_m, std::string kind = "bicycle_parking") {
  return {.at = at,
          .direction = 256,  // north
          .form = {.kind = std::move(kind), .width_m = 3, .depth_m = 1, .height_m = height_m}};
}

ClearZones zones_of(std::vector<things::Thing> things, std::vector<Vec2> trunks = {}) {
  const ground::LandCoverIndex none{};
  return clear_zones_of({.roads = {},
                         .junctions = {},
                         .yards = {},
                         .plots = {},
                         .pitches = {},
                         .trunks = trunks,
                         .things = things,
                         .lamps = {},
                         .barriers = {},
                         .buildings = {},
                         .land_cover = none,
                         .tile_m = 256});
}

OrientedRect square_at(Vec2 at) { return {.at = at, .ahead = {1, 0}, .length_m = 1, .width_m = 1}; }

TEST(ClearZones, HaveThePlansOfThings) {
  const ClearZones zones = zones_of({thing_at({0, 0}, 0.85)});
  // 3 m from west to east, 1 m from south to north
  EXPECT_TRUE(overlaps_any(zones.things, square_at({1.9, 0}), 0));
  EXPECT_FALSE(overlaps_any(zones.things, square_at({2.1, 0}), 0));
  EXPECT_FALSE(overlaps_any(zones.things, square_at({0, 1.1}), 0));
}

TEST(ClearZones, LeaveOutManholesThingsOnRoofsAndParkingSpaces) {
  things::Thing on_roof = thing_at({0, 0}, 1);
  on_roof.foot_m = 10;
  const std::string space(map::name_of(map::ThingRole::kCar));
  const ClearZones zones = zones_of({thing_at({0, 0}, 0.02), on_roof, thing_at({0, 0}, 1, space)});
  EXPECT_TRUE(zones.things.all.empty());
}

TEST(ClearZones, AreClearBesideTrunks) {
  const ClearZones zones = zones_of({}, {{0, 0}});
  EXPECT_FALSE(is_clear(zones.trunks, square_at({0.8, 0})));
  EXPECT_TRUE(is_clear(zones.trunks, square_at({0.9, 0})));
  EXPECT_TRUE(is_clear(zones.streets, square_at({0, 0})));
}

TEST(ClearZones, AreTestedAlongTheLongerSideOfARectangle) {
  const ClearZones zones = zones_of({}, {{0, 0}});
  EXPECT_FALSE(is_clear(zones.trunks, {.at = {0, 2}, .ahead = {1, 0}, .length_m = 1, .width_m = 4}));
  EXPECT_TRUE(is_clear(zones.trunks, {.at = {2, 0}, .ahead = {1, 0}, .length_m = 1, .width_m = 4}));
}

}  // namespace
}  // namespace citykiln::roadside

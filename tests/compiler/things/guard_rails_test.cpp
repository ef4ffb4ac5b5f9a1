#include "compiler/things/guard_rails.h"

#include <gtest/gtest.h>

#include "compiler/geometry/segment.h"

namespace citykiln::things {
namespace {

constexpr double kHalfRoad_m = 3;

// Level land at 20 m up to y = 64, and a slope of 1 : 1 beyond.
ground::GradedTerrain hillside() {
  map::Heightfield field{{0, 0}, {1, 1}, 257, 129, {}, 0};
  for (int y = 0; y < 129; ++y)
    for (int x = 0; x < 257; ++x)
      field.heights.push_back(static_cast<std::int32_t>((20.0 - std::max(0, y - 64)) / map::kHeightQuantum_m));
  return ground::GradedTerrain(std::move(field));
}

roads::Road lane(Polyline axis) {
  roads::Road road;
  road.id = {{OsmType::kWay, 5}, 0}, road.axis = std::move(axis), road.surface = map::LandCoverClass::kTertiaryRoad;
  road.section.lanes = {{.width_m = 2 * kHalfRoad_m}};
  road.section.axis_offset_m = kHalfRoad_m;
  return road;
}

struct Hillside {
  map::Features features;
  std::vector<roads::Road> roads{lane({{20, 60}, {230, 60}})};

  Hillside() { features.extent = {{0, 0}, {256, 128}}; }
  std::vector<props::Barrier> rails() const {
    Report report;
    return assumed_guard_rails(features, roads, hillside(), report);
  }
};

TEST(GuardRails, StandBesideRoadsAboveDrops) {
  const std::vector<props::Barrier> rails = Hillside().rails();
  ASSERT_EQ(rails.size(), 1u);
  EXPECT_EQ(rails[0].kind, map::BarrierKind::kGuardRail);
  EXPECT_GT(length_m(rails[0].axis), 190);
  for (const Vec2 p : rails[0].axis) EXPECT_NEAR(p.y, 60 + kHalfRoad_m + 0.5, 0.01) << "on the side of the drop";
}

TEST(GuardRails, LeaveRoomForOtherRoadsAndTowns) {
  Hillside crossed;
  crossed.roads.push_back(lane({{125, 20}, {125, 120}}));
  crossed.roads.back().id.osm.id = 6;
  for (const props::Barrier& rail : crossed.rails()) {
    if (rail.id.osm.id != 5) continue;
    EXPECT_GT(distance_to_polyline(rail.axis, {125, 63.5}), kHalfRoad_m + 2);
  }
  Hillside town;
  map::Footprint house;
  house.id = {{OsmType::kWay, 9}, 0}, house.polygon.outer = {{20, 45}, {230, 45}, {230, 55}, {20, 55}};
  town.features.footprints = {house};
  EXPECT_TRUE(town.rails().empty());
}

TEST(GuardRails, NeedADrop) {
  Hillside away;
  away.roads = {lane({{20, 30}, {230, 30}})};
  EXPECT_TRUE(away.rails().empty());
}

}  // namespace
}  // namespace citykiln::things

#include "compiler/things/junction_signals.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::things {
namespace {

using map::LaneDirection;
using map::LaneKind;

roads::Road road(std::int64_t id, Polyline axis, std::vector<LaneDirection> lanes) {
  roads::Road road;
  road.id = {{OsmType::kWay, id}, 0};
  road.axis = std::move(axis);
  road.surface = map::LandCoverClass::kResidentialRoad;
  for (const LaneDirection way : lanes) road.section.lanes.push_back({LaneKind::kDriving, way, 3});
  road.section.axis_offset_m = 3.0 * static_cast<double>(lanes.size()) / 2;
  return road;
}

constexpr LaneDirection kBack = LaneDirection::kBackward, kOn = LaneDirection::kForward;

// A street from west to east, and one to the north that traffic leaves by.
std::vector<roads::Road> t_junction() {
  return {road(1, {{-100, 0}, {0, 0}, {100, 0}}, {kBack, kOn, kOn}), road(2, {{0, 0}, {0, 100}}, {kOn})};
}

map::ThingFeature signal(std::int64_t id, Vec2 at, std::int64_t way = 1) {
  map::ThingFeature thing;
  thing.id = {{OsmType::kNode, id}, 0};
  thing.at = at;
  thing.kind = "traffic_signals";
  thing.way.id = {{OsmType::kWay, way}, 0};
  return thing;
}

std::vector<map::ThingFeature> signals(const std::vector<map::ThingFeature>& mapped) {
  const std::vector<roads::Road> roads = t_junction();
  Report report;
  return with_one_for_each_arm(mapped, roads, roads::plan_junctions(roads, report));
}

TEST(JunctionSignals, StandOnEachArmWithTrafficThatComesIn) {
  std::vector<map::ThingFeature> all = signals({signal(7, {0, 0})});
  ASSERT_EQ(all.size(), 2u) << "traffic only leaves by the street to the north";
  std::ranges::sort(all, {}, [](const map::ThingFeature& thing) { return thing.at.x; });
  EXPECT_EQ(all[0].way.along, (Vec2{1, 0}));
  EXPECT_EQ(all[1].way.along, (Vec2{-1, 0}));
  EXPECT_LT(all[0].at.x, -2);
  EXPECT_GT(all[0].at.x, -20);
  EXPECT_EQ(all[0].capacity, 2) << "lanes towards the junction";
  EXPECT_EQ(all[1].capacity, 1);
  for (const map::ThingFeature& thing : all) {
    EXPECT_EQ(thing.id.osm.id, 7);
    EXPECT_NE(thing.id.part, 0u);
    EXPECT_TRUE(thing.way.is_oneway);
  }
  EXPECT_NE(all[0].id.part, all[1].id.part);
}

TEST(JunctionSignals, AnArmWithASignalOfItsOwnHasNoOther) {
  const std::vector<map::ThingFeature> all = signals({signal(7, {0, 0}), signal(8, {50, 0}, 3), signal(9, {60, 0})});
  EXPECT_EQ(all.size(), 4u) << "too far away, or on another way";
  const std::vector<map::ThingFeature> near = signals({signal(7, {0, 0}), signal(8, {20, 0})});
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(near[0].id.osm.id, 8);
  EXPECT_LT(near[1].at.x, 0) << "the arm to the west";
}

TEST(JunctionSignals, OtherNodesStayAsTheyAre) {
  const std::vector<map::ThingFeature> all = signals({signal(8, {-100, 0})});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].at, (Vec2{-100, 0}));
  EXPECT_EQ(all[0].id.part, 0u);
}

}  // namespace
}  // namespace citykiln::things

#include "compiler/structures/plan_piers.h"

#include <gtest/gtest.h>

#include "tests/compiler/structures/made_spans.h"

namespace citykiln::structures {
namespace {

map::Heightfield level() {
  map::Heightfield field{{-512, -512}, {512, 512}, 3, 3, {}, 0};
  field.heights.assign(9, 0);
  return field;
}

ground::GradedTerrain graded() { return ground::grade_terrain(level(), {{}, {}, {}, {{-512, -512}, {512, 512}}}); }

ground::LandCoverPolygon band(map::LandCoverClass surface, double from_m, double to_m) {
  return {{{OsmType::kWay, 9}, 0}, surface, 1, {{{from_m, -50}, {to_m, -50}, {to_m, 50}, {from_m, 50}}}};
}

std::vector<Span> place(std::vector<Span> bridges, std::vector<ground::LandCoverPolygon> standing) {
  Report report;
  bridges = place_piers(std::move(bridges), graded(), standing, report);
  EXPECT_TRUE(report.balances());
  return bridges;
}

Span viaduct() { return made_span({{0, 0}, {120, 0}}, {{0, 10, 0}}); }

TEST(PlanPiers, DivideLongBridgesIntoBays) {
  const std::vector<Pier> piers = place({viaduct()}, {})[0].piers;
  EXPECT_EQ(piers, (std::vector<Pier>{{40, -0.5}, {80, -0.5}}));
  EXPECT_TRUE(place({made_span({{0, 0}, {28, 0}}, {{0, 10, 0}})}, {})[0].piers.empty());
}

TEST(PlanPiers, KeepClearOfRoads) {
  const ground::LandCoverPolygon road = band(map::LandCoverClass::kPrimaryRoad, 36, 43);
  const std::vector<Pier> piers = place({viaduct()}, {road})[0].piers;
  ASSERT_EQ(piers.size(), 2u);
  // at least half the wall's thickness from either edge
  EXPECT_GE(std::abs(piers[0].at_m - 39.5), 3.5 + kPierClear_m + 0.4);
  EXPECT_LE(std::abs(piers[0].at_m - 40), 6);
}

TEST(PlanPiers, AreOmittedWhereNoPositionIsFree) {
  Report report;
  const auto bridges =
      place_piers({viaduct()}, graded(), std::vector{band(map::LandCoverClass::kRailway, 20, 100)}, report);
  EXPECT_TRUE(bridges[0].piers.empty());
  EXPECT_EQ(report.counts()[Code::kNoPlaceForPier], 2u);
}

TEST(PlanPiers, AreInWaterOnlyWithoutADryPosition) {
  EXPECT_GE(place({viaduct()}, {band(map::LandCoverClass::kRiver, 32, 44)})[0].piers[0].at_m, 28);
  EXPECT_LE(place({viaduct()}, {band(map::LandCoverClass::kRiver, 32, 48)})[0].piers[0].at_m, 32);
  EXPECT_EQ(place({viaduct()}, {band(map::LandCoverClass::kRiver, 10, 110)})[0].piers[0].at_m, 40);
}

TEST(PlanPiers, DoNotPierceLowerDecks) {
  Span lower = made_span({{40, -50}, {40, 50}}, {{0, 5, 0}});
  lower.id.osm.id = 6;
  const std::vector<Span> placed = place({viaduct(), lower}, {});
  ASSERT_FALSE(placed[0].piers.empty());
  for (const Pier& pier : placed[0].piers) EXPECT_GT(std::abs(pier.at_m - 40), 3.25);
}

TEST(PlanPiers, AreOneWhereBridgesMeet) {
  Span a = made_span({{0, 0}, {25, 0}}, {{0, 10, 0}}), b = made_span({{25, 0}, {50, 0}}, {{0, 10, 0}});
  a.to = {EndKind::kJoint, {50, 0}, 0}, b.from = {EndKind::kJoint, {0, 0}, 0}, b.id.osm.id = 6;
  const auto bridges = place({a, b}, {});
  EXPECT_EQ(bridges[0].piers.size() + bridges[1].piers.size(), 1u);
}

TEST(PlanPiers, AreNoneUnderLowBridges) {
  EXPECT_TRUE(place({made_span({{0, 0}, {120, 0}}, {{0, 1.5, 0}})}, {})[0].piers.empty());
}

}  // namespace
}  // namespace citykiln::structures

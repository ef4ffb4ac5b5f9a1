#include "compiler/buildings/planning/street_sides.h"

#include <gtest/gtest.h>

#include "tests/compiler/buildings/made_footprint.h"

namespace citykiln::buildings {
namespace {

map::Track street(Polyline axis, map::LandCoverClass surface = map::LandCoverClass::kResidentialRoad) {
  map::Track track;
  track.axis = std::move(axis);
  track.surface = surface;
  return track;
}

std::vector<bool> sides(const std::vector<map::Track>& tracks) {
  return street_sides(rectangle(1, {0, 0}, 12, 10, 9).polygon, index_streets(tracks));
}

TEST(StreetSides, AreTheEdgesThatFaceAStreet) {
  EXPECT_EQ(sides({street({{-50, -8}, {50, -8}})}), (std::vector{true, false, false, false}));
  // at a corner of two streets
  EXPECT_EQ(sides({street({{-50, -8}, {50, -8}}), street({{20, -50}, {20, 50}})}),
            (std::vector{true, true, false, false}));
}

TEST(StreetSides, AreNoneForDistantStreets) {
  EXPECT_EQ(sides({street({{-50, -40}, {50, -40}})}), std::vector<bool>(4));
  EXPECT_EQ(sides({}), std::vector<bool>(4));
}

TEST(StreetSides, AreNotAtRailsPathsTunnelsAndBridges) {
  map::Track rail = street({{-50, -8}, {50, -8}}), tunnel = rail, bridge = rail;
  rail.is_rail = true;
  tunnel.passage = map::Passage::kTunnel, bridge.passage = map::Passage::kBridge;
  for (const map::Track& track : {rail, tunnel, bridge}) EXPECT_EQ(sides({track}), std::vector<bool>(4));
}

TEST(StreetSides, AreNotShortEdges) {
  const Polygon cut{{{0, 0}, {1, 0}, {12, 0.5}, {12, 10}, {0, 10}}, {}};
  EXPECT_EQ(street_sides(cut, index_streets(std::vector{street({{-50, -8}, {50, -8}})})),
            (std::vector{false, true, false, false, false}));
}

TEST(StreetSides, AreMeasuredFromTheKerb) {
  map::Track wide = street({{-50, -18}, {50, -18}});
  EXPECT_EQ(sides({wide}), std::vector<bool>(4));
  wide.section.lanes = {{map::LaneKind::kDriving, map::LaneDirection::kBoth, 12}};
  EXPECT_EQ(sides({wide}), (std::vector{true, false, false, false}));
}

}  // namespace
}  // namespace citykiln::buildings

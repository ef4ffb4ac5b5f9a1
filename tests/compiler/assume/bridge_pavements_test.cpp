#include "compiler/assume/bridge_pavements.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::assume {
namespace {

map::Track street_between(std::int64_t id, double from_m, double to_m) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  track.axis = {{from_m, 0}, {to_m, 0}};
  track.node_ids = {static_cast<std::int64_t>(from_m), static_cast<std::int64_t>(to_m)};
  track.surface = map::LandCoverClass::kResidentialRoad;
  track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 5.5}}, 2.75};
  return track;
}

// A street of 3 ways along the x axis: the middle one is a bridge, the others have pavements.
std::vector<map::Track> bridged(std::uint8_t before, std::uint8_t after) {
  std::vector<map::Track> tracks{street_between(1, 0, 100), street_between(2, 100, 150), street_between(3, 150, 250)};
  tracks[0].section = with_pavement(tracks[0].section, before, 2);
  tracks[2].section = with_pavement(tracks[2].section, after, 1.5);
  tracks[1].passage = map::Passage::kBridge;
  return tracks;
}

std::string bridge_of(std::vector<map::Track> tracks) {
  Report report;
  return to_string(assume_bridge_pavements(std::move(tracks), report)[1].section);
}

TEST(AssumeBridgePavements, BetweenTwoStreetsWithPavementsABridgeHasThem) {
  EXPECT_EQ(bridge_of(bridged(map::kBothSides, map::kBothSides)), "s|d|s -|-|-");
  EXPECT_EQ(bridge_of(bridged(map::kBothSides, map::kLeftSide)), "s|d -|-");
  EXPECT_EQ(bridge_of(bridged(map::kRightSide, map::kLeftSide)), "d -");
}

TEST(AssumeBridgePavements, WaysMayRunEitherWay) {
  std::vector<map::Track> tracks = bridged(map::kRightSide, map::kRightSide);
  std::ranges::reverse(tracks[2].axis), std::ranges::reverse(tracks[2].node_ids);
  std::ranges::reverse(tracks[2].section.lanes);
  EXPECT_EQ(bridge_of(tracks), "d|s -|-");
}

TEST(AssumeBridgePavements, TaggedAndLongBridgesStayAsTheyAre) {
  std::vector<map::Track> tracks = bridged(map::kBothSides, map::kBothSides);
  tracks[1].tagged_pavements = map::kLeftSide;
  EXPECT_EQ(bridge_of(tracks), "d|s -|-");
  tracks = bridged(map::kBothSides, map::kBothSides);
  tracks[1].axis.front().x = 150 - kLongestBridge_m - 1;
  EXPECT_EQ(bridge_of(tracks), "d -");
}

}  // namespace
}  // namespace citykiln::assume

#include "compiler/roads/kerb_parking.h"

#include <gtest/gtest.h>

namespace citykiln::roads {
namespace {

using map::LandCoverClass;
using map::LaneDirection;
using map::LaneKind;

map::Track street(double width_m, LandCoverClass surface = LandCoverClass::kResidentialRoad) {
  map::Track track;
  track.axis = {{0, 0}, {100, 0}};
  track.surface = surface;
  track.section.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, width_m / 2},
                         {LaneKind::kDriving, LaneDirection::kForward, width_m / 2}};
  track.section.axis_offset_m = width_m / 2;
  return track;
}

TEST(KerbParking, LeavesThreeMetresFree) {
  EXPECT_EQ(kerb_parking_of(street(5)), 0);
  EXPECT_EQ(kerb_parking_of(street(5.5)), map::kRightSide);
  EXPECT_EQ(kerb_parking_of(street(7.5)), map::kBothSides);
}

TEST(KerbParking, IsOnTheSideOfTraffic) {
  map::Track track = street(6);
  track.side = map::DrivingSide::kLeft;
  EXPECT_EQ(kerb_parking_of(track), map::kLeftSide);
}

TEST(KerbParking, LeavesMarkedLanesFree) {
  EXPECT_EQ(kerb_parking_of(street(6, LandCoverClass::kTertiaryRoad)), 0);
  EXPECT_EQ(kerb_parking_of(street(7.5, LandCoverClass::kTertiaryRoad)), map::kRightSide);
}

TEST(KerbParking, IsNotWhereTagsSaySomething) {
  map::Track track = street(7.5);
  track.tagged_parking = map::kRightSide;
  EXPECT_EQ(kerb_parking_of(track), map::kLeftSide);
  track.tagged_parking = map::kBothSides;
  EXPECT_EQ(kerb_parking_of(track), 0);
}

TEST(KerbParking, IsNotOnMainRoadsBridgesRampsAndBusLanes) {
  EXPECT_EQ(kerb_parking_of(street(9, LandCoverClass::kPrimaryRoad)), 0);
  map::Track bridge = street(9), ramp = street(9), buses = street(9);
  bridge.passage = map::Passage::kBridge, ramp.is_link = true;
  buses.section.lanes[1].kind = LaneKind::kBus;
  for (const map::Track& track : {bridge, ramp, buses}) EXPECT_EQ(kerb_parking_of(track), 0);
}

}  // namespace
}  // namespace citykiln::roads

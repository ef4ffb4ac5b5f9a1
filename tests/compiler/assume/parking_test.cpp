#include "compiler/assume/parking.h"

#include <gtest/gtest.h>

namespace citykiln::assume {
namespace {

using map::LaneDirection;
using map::LaneKind;

// A residential street with two lanes, as wide as tagged.
map::Track tagged_street(double width_m) {
  map::Track street;
  street.id = {{OsmType::kWay, 1}, 0};
  street.axis = {{0, 0}, {200, 0}}, street.node_ids = {1, 2};
  street.surface = map::LandCoverClass::kResidentialRoad;
  street.section = {{{LaneKind::kDriving, LaneDirection::kBackward, width_m / 2},
                     {LaneKind::kDriving, LaneDirection::kForward, width_m / 2}},
                    width_m / 2};
  street.has_tagged_width = true;
  return street;
}

std::string parked_between_houses(const map::Track& street) {
  map::Features features;
  features.tracks = {street};
  for (const double y : {9.0, -19.0}) {
    map::Footprint house;
    house.id = {{OsmType::kWay, static_cast<std::int64_t>(100 + y)}, 0};
    house.polygon.outer = {{0, y}, {200, y}, {200, y + 10}, {0, y + 10}};
    features.footprints.push_back(house);
  }
  Report report;
  const map::Track parked = assume_parking(features, report).front();
  EXPECT_EQ(carriageway_width_m(parked.section), carriageway_width_m(street.section));
  EXPECT_EQ(parked.section.axis_offset_m, street.section.axis_offset_m);
  return to_string(parked.section);
}

TEST(AssumeParking, AWideStreetBetweenHousesHasARowOnBothSides) {
  EXPECT_EQ(parked_between_houses(tagged_street(10)), "pddp vv^^");
}

TEST(AssumeParking, ANarrowerOneHasARowOnTheSideOfTraffic) {
  map::Track street = tagged_street(7.5);
  EXPECT_EQ(parked_between_houses(street), "ddp v^^");
  street.side = map::DrivingSide::kLeft;
  EXPECT_EQ(parked_between_houses(street), "pdd ^v^");
}

TEST(AssumeParking, WithoutATaggedWidthThereIsNone) {
  map::Track street = tagged_street(10);
  street.has_tagged_width = false;
  EXPECT_EQ(parked_between_houses(street), "dd v^");
}

TEST(AssumeParking, NothingIsAddedWhereTagsSpeakOfParking) {
  map::Track street = tagged_street(10);
  street.tagged_parking = map::kLeftSide;
  EXPECT_EQ(parked_between_houses(street), "dd v^");
}

TEST(AssumeParking, StreetsOfJapanHaveNone) {
  map::Track street = tagged_street(10);
  street.country = map::CountryGroup::kJapan;
  EXPECT_EQ(parked_between_houses(street), "dd v^");
}

}  // namespace
}  // namespace citykiln::assume

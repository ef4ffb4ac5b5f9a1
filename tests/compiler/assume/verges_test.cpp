#include "compiler/assume/verges.h"

#include <gtest/gtest.h>

namespace citykiln::assume {
namespace {

using map::LaneKind;

// A residential street of the suburbs with pavements on both sides, in residential land.
map::Features suburb(map::CountryGroup country) {
  map::Track street;
  street.id = {{OsmType::kWay, 1}, 0};
  street.axis = {{0, 0}, {200, 0}}, street.node_ids = {1, 2};
  street.surface = map::LandCoverClass::kResidentialRoad;
  street.section = with_pavement({{{LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3}, map::kBothSides, 1.5);
  street.tagged_pavements = map::kBothSides;
  street.country = country;
  map::AreaFeature area;
  area.id = {{OsmType::kWay, 50}, 0};
  area.polygon.outer = {{-100, -200}, {300, -200}, {300, 200}, {-100, 200}};
  area.surface = map::LandCoverClass::kResidential, area.area_m2 = 160000;
  map::Features features;
  features.tracks = {street}, features.areas = {area};
  return features;
}

map::Track with_verges(const map::Features& features) {
  Report report;
  return assume_verges(features, features.tracks, report).front();
}

TEST(AssumeVerges, SuburbsOfNorthAmericaHaveThemBetweenKerbAndPavement) {
  const map::Track street = with_verges(suburb(map::CountryGroup::kNorthAmerica));
  EXPECT_EQ(to_string(street.section), "sg|d|gs --|-|--");
  EXPECT_TRUE(has(street.assumed, Assumption::kVerges));
  EXPECT_EQ(to_string(with_verges(suburb(map::CountryGroup::kBritishIsles)).section), "s|d|s -|-|-");
}

TEST(AssumeVerges, ASideThatTagsDescribeStaysAsItIs) {
  map::Features features = suburb(map::CountryGroup::kNorthAmerica);
  features.tracks.front().tagged_verges = map::kLeftSide;
  EXPECT_EQ(to_string(with_verges(features).section), "s|d|gs -|-|--");
}

TEST(AssumeVerges, WallsNearTheKerbLeaveNoRoom) {
  map::Features features = suburb(map::CountryGroup::kNorthAmerica);
  map::Footprint house;
  house.id = {{OsmType::kWay, 60}, 0};
  house.polygon.outer = {{0, 7}, {190, 7}, {190, 15}, {0, 15}};
  features.footprints = {house};
  EXPECT_EQ(to_string(with_verges(features).section), "s|d|gs -|-|--");
}

TEST(AssumeVerges, WhatLiesBeyondTheRadiusChangesNothing) {
  map::Features features = suburb(map::CountryGroup::kNorthAmerica);
  const std::string alone = to_string(with_verges(features).section);
  // beyond the end of the street, as far from its other end
  map::Footprint house;
  house.id = {{OsmType::kWay, 60}, 0};
  house.polygon.outer = {{580, -7}, {600, -7}, {600, 7}, {580, 7}};
  features.footprints = {house};
  features.areas.front().polygon.outer = {{-70, -70}, {270, -70}, {270, 70}, {-70, 70}};
  EXPECT_EQ(to_string(with_verges(features).section), alone);
}

TEST(AssumeVerges, AssumedPavementsOfOtherStreetsLeaveAsMuchRoomAsNone) {
  map::Features features = suburb(map::CountryGroup::kNorthAmerica);
  map::Track other = features.tracks.front();
  other.id.osm.id = 2;
  other.axis = {{0, 12.5}, {200, 12.5}}, other.node_ids = {3, 4};
  const map::Track with_pavement = other;
  other.section = {{{LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  const std::vector<map::Track> mapped = {features.tracks.front(), other};
  features.tracks.push_back(with_pavement);
  Report report;
  EXPECT_EQ(to_string(assume_verges(features, mapped, report).front().section), "sg|d|gs --|-|--");
  EXPECT_EQ(to_string(with_verges(features).section), "s|d|gs -|-|--") << "a mapped pavement limits the room";
}

TEST(AssumeVerges, StreetsWithoutPavementsHaveNone) {
  map::Features features = suburb(map::CountryGroup::kNorthAmerica);
  features.tracks.front().section = {{{LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  EXPECT_EQ(to_string(with_verges(features).section), "d -");
}

}  // namespace
}  // namespace citykiln::assume

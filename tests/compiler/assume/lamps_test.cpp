#include "compiler/assume/lamps.h"

#include <gtest/gtest.h>

namespace citykiln::assume {
namespace {

using map::LandCoverClass;

map::Track dark_street(LandCoverClass surface = LandCoverClass::kResidentialRoad) {
  map::Track track;
  track.id = {{OsmType::kWay, 1}, 0};
  track.axis = {{0, 0}, {200, 0}}, track.node_ids = {1, 2};
  track.surface = surface;
  track.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 5.5}}, 2.75};
  return track;
}

bool is_lit_on(LandCoverClass land, const map::Track& street) {
  map::AreaFeature area;
  area.id = {{OsmType::kWay, 50}, 0};
  area.polygon.outer = {{-100, -200}, {300, -200}, {300, 200}, {-100, 200}};
  area.surface = land, area.area_m2 = 160000;
  map::Features features;
  features.tracks = {street}, features.areas = {area};
  Report report;
  const map::Track lit = assume_lamps(features, report).front();
  EXPECT_EQ(lit.is_lit && !street.is_lit, has(lit.assumed, Assumption::kLamps));
  return lit.is_lit;
}

TEST(AssumeLamps, AStreetOnResidentialLandIsLit) {
  EXPECT_TRUE(is_lit_on(LandCoverClass::kResidential, dark_street()));
}

TEST(AssumeLamps, AStreetThroughFieldsOrWoodsIsDark) {
  EXPECT_FALSE(is_lit_on(LandCoverClass::kFarmland, dark_street()));
  EXPECT_FALSE(is_lit_on(LandCoverClass::kForest, dark_street()));
}

TEST(AssumeLamps, MotorwaysDrivewaysAndFarmTracksAreDark) {
  for (const auto surface : {LandCoverClass::kMotorwayRoad, LandCoverClass::kServiceRoad, LandCoverClass::kFarmTrack})
    EXPECT_FALSE(is_lit_on(LandCoverClass::kResidential, dark_street(surface)));
}

TEST(AssumeLamps, APavedPathBetweenHousesIsLit) {
  map::Features features;
  features.tracks = {dark_street(LandCoverClass::kPavedFootPath)};
  map::AreaFeature area;
  area.id = {{OsmType::kWay, 50}, 0};
  area.polygon.outer = {{-100, -200}, {300, -200}, {300, 200}, {-100, 200}};
  area.surface = LandCoverClass::kResidential, area.area_m2 = 160000;
  features.areas = {area};
  Report report;
  EXPECT_FALSE(assume_lamps(features, report).front().is_lit);
  map::Footprint house;
  house.id = {{OsmType::kWay, 60}, 0};
  house.polygon.outer = {{0, 7}, {190, 7}, {190, 15}, {0, 15}};
  features.footprints = {house};
  EXPECT_TRUE(assume_lamps(features, report).front().is_lit);
  features.areas.front().surface = LandCoverClass::kPark;
  EXPECT_FALSE(assume_lamps(features, report).front().is_lit);
}

TEST(AssumeLamps, AStreetThatTagsCallUnlitStaysDark) {
  map::Track street = dark_street();
  street.has_tagged_lighting = true;
  EXPECT_FALSE(is_lit_on(LandCoverClass::kResidential, street));
}

}  // namespace
}  // namespace citykiln::assume

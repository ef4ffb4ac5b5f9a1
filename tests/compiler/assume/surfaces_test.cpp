#include "compiler/assume/surfaces.h"

#include <gtest/gtest.h>

namespace citykiln::assume {
namespace {

using map::LandCoverClass;

map::Features way_in(LandCoverClass land, LandCoverClass surface) {
  map::Track way;
  way.id = {{OsmType::kWay, 1}, 0};
  way.axis = {{0, 0}, {200, 0}}, way.node_ids = {1, 2};
  way.surface = surface;
  way.section = {{{map::LaneKind::kFoot, map::LaneDirection::kBoth, 2}}, 1};
  map::AreaFeature area;
  area.id = {{OsmType::kWay, 50}, 0};
  area.polygon.outer = {{-100, -200}, {300, -200}, {300, 200}, {-100, 200}};
  area.surface = land, area.area_m2 = 160000;
  map::Features features;
  features.tracks = {way}, features.areas = {area};
  return features;
}

LandCoverClass surface_of(const map::Features& features) {
  Report report;
  const map::Track way = assume_surfaces(features, report).front();
  EXPECT_EQ(way.surface != features.tracks.front().surface, has(way.assumed, Assumption::kSurfaces));
  return way.surface;
}

TEST(AssumeSurfaces, FootpathsThroughWoodsAreUnpavedAndThoseOfTownsPaved) {
  const LandCoverClass paved = LandCoverClass::kPavedFootPath;
  EXPECT_EQ(surface_of(way_in(LandCoverClass::kForest, paved)), LandCoverClass::kFootPath);
  EXPECT_EQ(surface_of(way_in(LandCoverClass::kResidential, paved)), paved);
}

TEST(AssumeSurfaces, LandBeyondTheRadiusChangesNothing) {
  map::Features features = way_in(LandCoverClass::kForest, LandCoverClass::kPavedFootPath);
  map::AreaFeature town = features.areas.front();
  town.id = {{OsmType::kWay, 51}, 0}, town.surface = LandCoverClass::kResidential;
  town.polygon.outer = {{580, -200}, {900, -200}, {900, 200}, {580, 200}};
  features.areas.push_back(town);
  EXPECT_EQ(surface_of(features), LandCoverClass::kFootPath);
}

TEST(AssumeSurfaces, DrivewaysThroughFieldsAreUnpaved) {
  EXPECT_EQ(surface_of(way_in(LandCoverClass::kFarmland, LandCoverClass::kServiceRoad)), LandCoverClass::kUnpavedRoad);
}

TEST(AssumeSurfaces, TaggedSurfacesStay) {
  map::Features features = way_in(LandCoverClass::kForest, LandCoverClass::kPavedFootPath);
  features.tracks.front().has_tagged_surface = true;
  EXPECT_EQ(surface_of(features), LandCoverClass::kPavedFootPath);
}

}  // namespace
}  // namespace citykiln::assume

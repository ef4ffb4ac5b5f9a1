#include "compiler/assume/frontages.h"

#include <gtest/gtest.h>

#include "compiler/assume/footway_strips.h"
#include "compiler/assume/pavements.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::assume {
namespace {

using map::LandCoverClass;
using map::Lane;
using map::LaneDirection;
using map::LaneKind;

// A street along the x axis with a node every 50 m, two lanes of 2.75 m in its middle.
map::Track street_of(LandCoverClass surface = LandCoverClass::kResidentialRoad) {
  map::Track track;
  track.id = {{OsmType::kWay, 1}, 0};
  for (int i = 0; i <= 4; ++i) track.axis.push_back({50.0 * i, 0}), track.node_ids.push_back(100 + i);
  track.surface = surface;
  track.section.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, 2.75},
                         {LaneKind::kDriving, LaneDirection::kForward, 2.75}};
  track.section.axis_offset_m = 2.75;
  return track;
}

map::Track way_of_foot(double y, double width_m, LandCoverClass surface = LandCoverClass::kPavedFootPath) {
  map::Track path = street_of(surface);
  path.id.osm.id = 2;
  for (Vec2& p : path.axis) p.y = y;
  path.section.lanes = {{LaneKind::kFoot, LaneDirection::kBoth, width_m}};
  path.section.axis_offset_m = width_m / 2;
  path.tagged_pavements = path.fixed_pavements = path.tagged_verges = map::kBothSides;
  return path;
}

Ring box_ring(Vec2 least, Vec2 most) { return {least, {most.x, least.y}, most, {least.x, most.y}}; }

// Houses of 18 m every 20 m, whose fronts are this far from the axis, on the left or the right.
void add_row(map::Features& features, double away_m, double levels, bool is_left = true) {
  for (int i = 0; i < 10; ++i) {
    map::Footprint house;
    house.id = {{OsmType::kWay, static_cast<std::int64_t>(1000 + 100 * is_left + i)}, 0};
    const Vec2 least{20.0 * i, is_left ? away_m : -away_m - 10};
    house.polygon.outer = box_ring(least, least + Vec2{18, 10});
    house.levels = levels, house.height_m = 3 * levels;
    features.footprints.push_back(house);
  }
}

map::Features fronted_town(map::Track track, double away_m, double levels = 4) {
  map::Features features;
  features.tracks = {std::move(track)};
  add_row(features, away_m, levels);
  return features;
}

map::Track fronted(const map::Features& features) {
  Report report;
  return assume_frontages(features, features.tracks, report).front();
}

TEST(AssumeFrontages, TownHousesNearTheKerbArePavedUpTo) {
  const map::Track track = fronted(fronted_town(street_of(), 2.75 + 4.1));
  EXPECT_EQ(to_string(track.section), "s|dd -|v^");
  EXPECT_EQ(track.section.lanes.front().width_m, 4);
  EXPECT_EQ(int{track.closed_sides}, map::kLeftSide);
  EXPECT_TRUE(has(track.assumed, Assumption::kPavements));
}

TEST(AssumeFrontages, CottagesKeepTheirGardens) {
  EXPECT_EQ(fronted(fronted_town(street_of(), 2.75 + 4.1, 1)).section, street_of().section);
  EXPECT_EQ(fronted(fronted_town(street_of(), 2.75 + 2.1, 1)).section.lanes.front().width_m, 2);
}

TEST(AssumeFrontages, WallsFarFromTheKerbDoNotCount) {
  EXPECT_EQ(fronted(fronted_town(street_of(), 2.75 + 8.5)).section, street_of().section);
}

TEST(AssumeFrontages, APavementWithoutATaggedWidthBecomesWider) {
  map::Track street = street_of();
  street.section = with_pavement(street.section, map::kLeftSide, 2), street.tagged_pavements = map::kBothSides;
  EXPECT_EQ(fronted(fronted_town(street, 2.75 + 4.1)).section.lanes.front().width_m, 4);
  street.fixed_pavements = map::kLeftSide;
  EXPECT_EQ(fronted(fronted_town(street, 2.75 + 4.1)).section.lanes.front().width_m, 2);
}

TEST(AssumeFrontages, LandThatIsMappedMoreFinelyIsNotCovered) {
  map::Features features = fronted_town(street_of(), 2.75 + 6.1);
  map::AreaFeature grass;
  grass.id = {{OsmType::kWay, 50}, 0};
  grass.polygon.outer = box_ring({70, 2.75 + 3.1}, {90, 2.75 + 5});
  grass.surface = LandCoverClass::kGrass, grass.area_m2 = 38;
  features.areas = {grass};
  EXPECT_EQ(fronted(features).section.lanes.front().width_m, 3);
}

TEST(AssumeFrontages, ATaggedVergeOutsideThePavementKeepsTheSideAsItIs) {
  map::Track street = street_of();
  street.section = with_pavement(street.section, map::kLeftSide, 2);
  street.section.lanes.insert(street.section.lanes.begin(), Lane{LaneKind::kVerge, LaneDirection::kBoth, 1, 0, true});
  street.tagged_verges = map::kLeftSide;
  const map::Track track = fronted(fronted_town(street, 2.75 + 6.1));
  EXPECT_EQ(track.section, street.section) << to_string(track.section);
  EXPECT_EQ(int{track.closed_sides}, map::kLeftSide);
}

TEST(AssumeFrontages, ClosedSidesAreKnownWhereNothingBecomesWider) {
  map::Track street = street_of();
  street.section = with_pavement(street.section, map::kBothSides, 4);
  // it already reaches the wall
  EXPECT_EQ(int{fronted(fronted_town(street, 2.75 + 4.1)).closed_sides}, map::kLeftSide);
  for (const std::uint8_t fixed : {map::kLeftSide, map::kBothSides}) {
    street.fixed_pavements = fixed;
    const map::Track track = fronted(fronted_town(street, 2.75 + 6.1));
    EXPECT_EQ(int{track.closed_sides}, map::kLeftSide) << int{fixed};
    EXPECT_EQ(track.section, street.section);
    EXPECT_FALSE(has(track.assumed, Assumption::kPavements));
  }
  EXPECT_EQ(int{fronted(fronted_town(street_of(), 2.75 + 8.5)).closed_sides}, 0);
}

TEST(AssumeFrontages, AWideFootwayCountsByItsNearerEdge) {
  map::Features features = fronted_town(street_of(), 20, 2);
  // from 9.5 to 12.5 m from the kerb
  features.tracks.push_back(way_of_foot(2.75 + 11, 3));
  const BothFootwayStrips strips = footway_strips(index_surroundings(features), features.tracks.front());
  EXPECT_EQ(strips.left.near_m, 9.5);
  EXPECT_EQ(strips.left.far_m, 12.5);
  for (Vec2& p : features.tracks.back().axis) p.y += 1;
  EXPECT_EQ(footway_strips(index_surroundings(features), features.tracks.front()).left.far_m, 0);
}

TEST(AssumeFrontages, LongPedestrianStreetsReachTheWallsInPieces) {
  map::Track street = way_of_foot(0, 4.5, LandCoverClass::kPedestrianStreet);
  for (int i = 5; i <= 20; ++i) street.axis.push_back({50.0 * i, 0}), street.node_ids.push_back(100 + i);
  map::Features features = fronted_town(street, 5.25 + 0.1);
  add_row(features, 4.25, 4, false);
  Report report;
  const std::vector<map::Track> pieces = assume_frontages(features, features.tracks, report);
  ASSERT_GT(pieces.size(), 1u);
  // the rows of houses are 200 m long
  EXPECT_EQ(pieces.front().section.lanes.front().width_m, 4.5 + 3 + 2);
  EXPECT_EQ(pieces.back().section.lanes.front().width_m, 4.5);
}

TEST(AssumeFrontages, AFootwayBesideTheKerbIsCoveredWhereHousesAreNear) {
  map::Features features = fronted_town(street_of(), 16, 2);
  features.tracks.push_back(way_of_foot(6.75, 2));
  EXPECT_EQ(fronted(features).section.lanes.front(), map::pavement_lane(5));
  features.footprints.clear();
  EXPECT_EQ(fronted(features).section, street_of().section);
}

TEST(AssumeFrontages, CyclePathsLieOnThePavementThatReachesTheWalls) {
  map::Features features = fronted_town(street_of(), 2.75 + 6.1);
  features.tracks.push_back(way_of_foot(2.75 + 2.5, 1.5, LandCoverClass::kCyclePath));
  EXPECT_EQ(fronted(features).section.lanes.front().width_m, 6);
  features.tracks.back() = way_of_foot(2.75 + 2.5, 1.5, LandCoverClass::kServiceRoad);
  EXPECT_LT(fronted(features).section.lanes.front().width_m, 3);
}

TEST(AssumeFrontages, VergesLieBeforeOpenHousesOfGroupsThatHaveThem) {
  map::Features features = fronted_town(street_of(), 16, 2);
  features.tracks.front().country = map::CountryGroup::kOceania;
  features.tracks.push_back(way_of_foot(6.75, 2));
  map::AreaFeature land;
  land.id = {{OsmType::kWay, 51}, 0};
  land.polygon.outer = box_ring({-100, -200}, {400, 200});
  land.surface = LandCoverClass::kResidential, land.area_m2 = 200000;
  features.areas = {land};
  for (std::size_t i = 0; i < features.footprints.size(); i += 3)
    for (Vec2& p : features.footprints[i].polygon.outer) p.y += 100;
  const Lane verge = fronted(features).section.lanes.front();
  EXPECT_EQ(verge.kind, LaneKind::kVerge);
  EXPECT_EQ(verge.width_m, 3);
}

TEST(AssumeFrontages, WhatLiesBeyondTheRadiusChangesNothing) {
  map::Features features = fronted_town(street_of(), 6);
  const map::CrossSection alone = fronted(features).section;
  EXPECT_NE(alone, street_of().section);
  // as far from the street's other end
  map::Footprint house = features.footprints.front();
  house.id.osm.id = 5000;
  const double beyond_m = kPavementRadius_m + 10;
  house.polygon.outer = box_ring({beyond_m, 3}, {beyond_m + 100, 30});
  features.footprints.push_back(house);
  EXPECT_EQ(fronted(features).section, alone);
}

TEST(AssumeFrontages, PedestrianStreetsAndAlleysReachTheWalls) {
  map::Features features = fronted_town(way_of_foot(0, 4.5, LandCoverClass::kPedestrianStreet), 5.25 + 0.1);
  EXPECT_EQ(fronted(features).section.lanes.front().width_m, 4.5);
  add_row(features, 4.25, 4, false);
  const map::Track wide = fronted(features);
  EXPECT_EQ(wide.section.lanes.front().width_m, 4.5 + 3 + 2);
  EXPECT_EQ(wide.section.axis_offset_m, 2.25 + 3);
  features.tracks.front().has_tagged_width = true;
  EXPECT_EQ(fronted(features).section.lanes.front().width_m, 4.5);
}

// A service road of 3.5 m whose walls stand this far from its edges.
double width_of_alley(double left_m, double right_m) {
  map::Track alley = way_of_foot(0, 3.5, LandCoverClass::kServiceRoad);
  alley.section.lanes.front().kind = LaneKind::kDriving;
  map::Features features = fronted_town(alley, 1.75 + left_m + 0.1);
  add_row(features, 1.75 + right_m + 0.1, 4, false);
  return fronted(features).section.lanes.front().width_m;
}

TEST(AssumeFrontages, ServiceRoadsReachWallsThatAreNearOnBothSides) {
  EXPECT_EQ(width_of_alley(1, 2), 3.5 + 1 + 2);
  EXPECT_EQ(width_of_alley(1, 5), 3.5) << "a yard on one side";
  EXPECT_EQ(width_of_alley(8, 8), 3.5);
}

}  // namespace
}  // namespace citykiln::assume

#include "compiler/assume/pavements.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/assume/cut_way.h"

namespace citykiln::assume {
namespace {

using map::LandCoverClass;
using map::Lane;
using map::LaneDirection;
using map::LaneKind;

// A street along the x axis with a node every 50 m, two lanes of 2.75 m in its middle.
map::Track silent_street(double long_m = 200, LandCoverClass surface = LandCoverClass::kResidentialRoad) {
  map::Track track;
  track.id = {{OsmType::kWay, 1}, 0};
  for (int i = 0; i <= long_m / 50; ++i) track.axis.push_back({50.0 * i, 0}), track.node_ids.push_back(100 + i);
  track.surface = surface;
  track.section.lanes = {{LaneKind::kDriving, LaneDirection::kBackward, 2.75},
                         {LaneKind::kDriving, LaneDirection::kForward, 2.75}};
  track.section.axis_offset_m = 2.75;
  return track;
}

map::Track path_beside(double y) {
  map::Track path = silent_street(200, LandCoverClass::kPavedFootPath);
  path.id.osm.id = 2;
  for (Vec2& p : path.axis) p.y = y;
  path.section.lanes = {{LaneKind::kFoot, LaneDirection::kBoth, 2}};
  path.section.axis_offset_m = 1;
  path.tagged_pavements = map::kBothSides;
  return path;
}

Ring rectangle(Vec2 least, Vec2 most) { return {least, {most.x, least.y}, most, {least.x, most.y}}; }

map::AreaFeature land(LandCoverClass surface, std::int64_t id = 50) {
  map::AreaFeature area;
  area.id = {{OsmType::kWay, id}, 0};
  area.polygon.outer = rectangle({-100, -200}, {3000, 200});
  area.surface = surface, area.area_m2 = 400 * 3100;
  return area;
}

// A house every 20 m, whose fronts are this far from the axis, on the left.
std::vector<map::Footprint> houses(double away_m, double long_m = 200) {
  std::vector<map::Footprint> all;
  for (int i = 0; 20 * i < long_m; ++i) {
    map::Footprint house;
    house.id = {{OsmType::kWay, 1000 + i}, 0};
    house.polygon.outer = rectangle({20.0 * i, away_m}, {20.0 * i + 18, away_m + 10});
    all.push_back(house);
  }
  return all;
}

map::Features town(map::Track street, double away_m = 12) {
  map::Features features;
  features.tracks = {std::move(street)};
  features.areas = {land(LandCoverClass::kResidential)};
  features.footprints = houses(away_m);
  return features;
}

map::CrossSection section_in(const map::Features& features) {
  Report report;
  return assume_pavements(features, report).front().section;
}

int pavements_in(const map::Features& features) {
  return static_cast<int>(std::ranges::count(section_in(features).lanes, LaneKind::kSidewalk, &Lane::kind));
}

TEST(AssumePavements, AStreetAmongHousesHasThemOnBothSides) {
  Report report;
  const auto tracks = assume_pavements(town(silent_street()), report);
  EXPECT_EQ(to_string(tracks.front().section), "s|dd|s -|v^|-");
  EXPECT_TRUE(has(tracks.front().assumed, Assumption::kPavements));
  EXPECT_EQ(report.assumed(Assumption::kPavements), 1U);
}

TEST(AssumePavements, AStreetThroughFieldsHasNone) {
  map::Features features;
  features.tracks = {silent_street()};
  features.areas = {land(LandCoverClass::kFarmland)};
  EXPECT_EQ(pavements_in(features), 0);
}

TEST(AssumePavements, WithoutHousesCrossStreetsMakeATown) {
  map::Features features;
  features.tracks = {silent_street()};
  EXPECT_EQ(pavements_in(features), 0);
  for (int i = 0; i < 3; ++i) {
    map::Track cross = silent_street();
    cross.id.osm.id = 10 + i;
    for (Vec2& p : cross.axis) p = {50.0 * i + 50, p.x - 100};
    features.tracks.push_back(cross);
  }
  EXPECT_EQ(pavements_in(features), 2);
}

TEST(AssumePavements, MotorwaysAndDrivewaysHaveNone) {
  EXPECT_EQ(pavements_in(town(silent_street(200, LandCoverClass::kMotorwayRoad))), 0);
  EXPECT_EQ(pavements_in(town(silent_street(200, LandCoverClass::kServiceRoad))), 0);
}

TEST(AssumePavements, ASideThatTagsDescribeStaysAsItIs) {
  map::Track street = silent_street();
  street.tagged_pavements = map::kLeftSide;
  EXPECT_EQ(to_string(section_in(town(street))), "dd|s v^|-");
  street.tagged_pavements = map::kBothSides;
  EXPECT_EQ(pavements_in(town(street)), 0);
}

TEST(AssumePavements, APathBesideTheKerbIsThePavement) {
  map::Features features = town(silent_street(), 30);
  features.tracks.push_back(path_beside(6));
  EXPECT_EQ(to_string(section_in(features)), "dd|s v^|-");
  features.tracks.back() = path_beside(25);
  EXPECT_EQ(pavements_in(features), 2);
}

TEST(AssumePavements, ItIsAsNarrowAsTheRoomBeforeTheHouses) {
  const map::CrossSection section = section_in(town(silent_street(), 2.75 + 1.4));
  EXPECT_EQ(section.lanes.front().kind, LaneKind::kSidewalk);
  EXPECT_EQ(section.lanes.front().width_m, 1.25);
  EXPECT_EQ(to_string(section_in(town(silent_street(), 2.75 + 0.8))), "dd|s v^|-");
}

// A shed in the carriageway (Kyoto, w832055419) lies between two samples.
TEST(AssumePavements, ItIsNowhereInABuildingHoweverSmall) {
  map::Features features = town(silent_street(), 30);
  map::Footprint shed = features.footprints.front();
  shed.id.osm.id = 3000;
  shed.polygon.outer = rectangle({100.5, 2.1}, {103, 5.3});
  features.footprints.push_back(shed);
  EXPECT_EQ(to_string(section_in(features)), "dd|s v^|-");
}

// A service road that ends beside the street without a node of it (Monaco, w690914540).
TEST(AssumePavements, ItIsNowhereOnAnotherCarriageway) {
  map::Features features = town(silent_street(), 30);
  map::Track service = silent_street(50, LandCoverClass::kServiceRoad);
  service.id.osm.id = 2;
  service.axis = {{101, 5}, {108, 12}};
  service.section.lanes = {{LaneKind::kDriving, LaneDirection::kBoth, 3.5}}, service.section.axis_offset_m = 1.75;
  features.tracks.push_back(service);
  EXPECT_EQ(to_string(section_in(features)), "dd|s v^|-");
}

TEST(AssumePavements, ItIsNowhereInWaterOrOnASquare) {
  for (const LandCoverClass surface : {LandCoverClass::kLake, LandCoverClass::kSquare}) {
    map::Features features = town(silent_street(), 30);
    features.areas.push_back(land(surface, 60));
    features.areas.back().polygon.outer = rectangle({101, 3.5}, {103, 6}), features.areas.back().area_m2 = 5;
    EXPECT_EQ(to_string(section_in(features)), "dd|s v^|-");
  }
}

TEST(AssumePavements, ItIsNowhereInWaterThatBeginsWithinTheCarriageway) {
  map::Features features = town(silent_street(), 30);
  features.areas.push_back(land(LandCoverClass::kLake, 60));
  features.areas.back().polygon.outer = {{-100, -2}, {400, 2}, {400, 9}, {-100, 9}},
  features.areas.back().area_m2 = 4000;
  EXPECT_EQ(to_string(section_in(features)), "dd|s v^|-");
}

TEST(AssumePavements, AStreetThatMeetsTheStretchLeavesRoom) {
  map::Features features = town(silent_street(), 30);
  map::Track side_street = silent_street(50);
  side_street.id.osm.id = 2;
  side_street.axis = {{100, 0}, {130, 12}};
  features.tracks.push_back(side_street);
  EXPECT_EQ(pavements_in(features), 2);
}

// Streets of Manhattan: no land use, one way, houses on both sides.
TEST(AssumePavements, AOneWayStreetBetweenHousesHasThemOnBothSides) {
  map::Track street = silent_street();
  street.is_oneway = true;
  for (Lane& lane : street.section.lanes) lane.way = LaneDirection::kForward;
  map::Features features = town(street);
  features.areas.clear();
  for (map::Footprint& house : houses(12)) {
    for (Vec2& p : house.polygon.outer) p.y = -p.y;
    house.id.osm.id += 100;
    features.footprints.push_back(house);
  }
  EXPECT_EQ(pavements_in(features), 2);
}

TEST(AssumePavements, ADualCarriagewayHasThemOutside) {
  map::Track there = silent_street(200, LandCoverClass::kPrimaryRoad), back = there;
  there.is_oneway = back.is_oneway = true;
  for (Lane& lane : there.section.lanes) lane.way = LaneDirection::kForward;
  back.section = there.section;
  back.id.osm.id = 2;
  std::ranges::reverse(back.axis);
  for (Vec2& p : back.axis) p.y = 12;
  map::Features features = town(there, 30);
  features.tracks.push_back(back);
  Report report;
  const auto tracks = assume_pavements(features, report);
  EXPECT_EQ(to_string(tracks[0].section), "dd|s ^^|-");
  EXPECT_EQ(to_string(tracks[1].section), "dd|s ^^|-");
}

TEST(AssumePavements, ARoundaboutHasThemOutside) {
  map::Track ring = silent_street();
  ring.is_roundabout = true;
  EXPECT_EQ(to_string(section_in(town(ring, 30))), "dd|s v^|-");
  ring.side = map::DrivingSide::kLeft;
  EXPECT_EQ(to_string(section_in(town(ring, 30))), "s|dd -|v^");
}

TEST(AssumePavements, AResidentialStreetOfJapanHasNone) {
  map::Track street = silent_street();
  street.country = map::CountryGroup::kJapan;
  EXPECT_EQ(pavements_in(town(street)), 0);
}

TEST(AssumePavements, ALongWayIsCutAndItsEndDoesNotChangeItsBeginning) {
  map::Features features = town(silent_street(2000));
  features.tracks.front().points = {{.vertex = 7, .kind = map::TrackPointKind::kZebra, .facing = 0}};
  Report report;
  const auto tracks = assume_pavements(features, report);
  ASSERT_GT(tracks.size(), 7U);
  std::size_t points = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    EXPECT_EQ(tracks[i].id.part, i);
    EXPECT_TRUE(tracks[i].is_piece);
    EXPECT_LE(length_m(tracks[i].axis), 2 * kStretch_m);
    EXPECT_EQ(tracks[i].axis.size(), tracks[i].node_ids.size());
    points += tracks[i].points.size();
    for (const map::TrackPoint& point : tracks[i].points) EXPECT_EQ(tracks[i].axis[point.vertex].x, 350);
    if (i > 0) {
      EXPECT_EQ(tracks[i].axis.front(), tracks[i - 1].axis.back());
      EXPECT_EQ(tracks[i].node_ids.front(), tracks[i - 1].node_ids.back());
    }
  }
  EXPECT_EQ(points, 1U);
  EXPECT_TRUE(report.balances());
  // houses stand along the first 200 m alone
  const std::size_t lanes = tracks.front().section.lanes.size();
  EXPECT_GT(lanes, 2U);
  map::Features without = features;
  without.areas.push_back(land(LandCoverClass::kFarmland, 60));
  without.areas.back().polygon.outer = rectangle({1000, -200}, {3000, 200}), without.areas.back().area_m2 = 1;
  Report other;
  EXPECT_EQ(assume_pavements(without, other).front().section, tracks.front().section);
}

TEST(CutWay, ACutDependsOnTheNodesOfItsWindow) {
  map::Track way = silent_street(2000);
  const std::vector<map::Track> plain = cut_way(way, 512, 256, {});
  ASSERT_EQ(plain.size(), 8U);
  EXPECT_EQ(plain[0].axis.back().x, 250) << "the last node of the first window";
  EXPECT_EQ(plain[1].axis.back().x, 500);
  const std::vector<map::Track> crossed = cut_way(way, 512, 256, {way.node_ids[3]});
  ASSERT_EQ(crossed.size(), 8U);
  EXPECT_EQ(crossed[0].axis.back().x, 150) << "a common node";
  for (std::size_t i = 1; i < 8; ++i) EXPECT_EQ(crossed[i].axis.back(), plain[i].axis.back()) << i;
}

TEST(AssumePavements, TheOrderOfFeaturesDoesNotMatter) {
  map::Features features = town(silent_street());
  const map::CrossSection section = section_in(features);
  std::ranges::reverse(features.footprints);
  EXPECT_EQ(section_in(features), section);
}

}  // namespace
}  // namespace citykiln::assume

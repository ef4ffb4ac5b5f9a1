#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

TEST(LocateAreas, TagsDecideTheClass) {
  const struct {
    const char* tags;
    LandCoverClass surface;
  } cases[] = {
      {"natural=wood", LandCoverClass::kForest},
      {"landuse=forest leaf_type=broadleaved", LandCoverClass::kBroadLeavedForest},
      {"landuse=forest leaf_type=needleleaved", LandCoverClass::kNeedleLeavedForest},
      {"natural=wood leaf_type=mixed", LandCoverClass::kMixedForest},
      {"landuse=meadow", LandCoverClass::kMeadow},
      {"landuse=grass", LandCoverClass::kGrass},
      {"leisure=park", LandCoverClass::kPark},
      {"leisure=garden", LandCoverClass::kGarden},
      {"landuse=orchard", LandCoverClass::kOrchard},
      {"landuse=vineyard", LandCoverClass::kVineyard},
      {"landuse=farmland", LandCoverClass::kFarmland},
      {"landuse=farmyard", LandCoverClass::kFarmyard},
      {"landuse=allotments", LandCoverClass::kAllotments},
      {"landuse=cemetery", LandCoverClass::kCemetery},
      {"natural=scrub", LandCoverClass::kScrub},
      {"natural=heath", LandCoverClass::kHeath},
      {"natural=wetland", LandCoverClass::kWetland},
      {"natural=wetland wetland=marsh", LandCoverClass::kMarsh},
      {"natural=wetland wetland=reedbed", LandCoverClass::kReedbed},
      {"natural=beach", LandCoverClass::kBeach},
      {"natural=sand", LandCoverClass::kSand},
      {"natural=bare_rock", LandCoverClass::kBareRock},
      {"natural=scree", LandCoverClass::kScree},
      {"natural=glacier", LandCoverClass::kGlacier},
      {"landuse=quarry", LandCoverClass::kQuarry},
      {"landuse=residential", LandCoverClass::kResidential},
      {"landuse=commercial", LandCoverClass::kCommercial},
      {"landuse=retail", LandCoverClass::kRetail},
      {"landuse=industrial", LandCoverClass::kIndustrial},
      {"landuse=railway", LandCoverClass::kRailwayLand},
      {"landuse=construction", LandCoverClass::kConstruction},
      {"landuse=brownfield", LandCoverClass::kBrownfield},
      {"landuse=landfill", LandCoverClass::kLandfill},
      {"landuse=military", LandCoverClass::kMilitary},
      {"amenity=school", LandCoverClass::kInstitution},
      {"amenity=hospital", LandCoverClass::kInstitution},
      {"leisure=pitch sport=soccer", LandCoverClass::kPitch},
      {"leisure=pitch sport=tennis", LandCoverClass::kHardCourt},
      {"leisure=track", LandCoverClass::kRunningTrack},
      {"leisure=playground", LandCoverClass::kPlayground},
      {"leisure=golf_course", LandCoverClass::kGolfCourse},
      {"amenity=parking", LandCoverClass::kParking},
      {"highway=pedestrian area=yes", LandCoverClass::kSquare},
      {"man_made=pier", LandCoverClass::kPier},
      {"natural=water", LandCoverClass::kPond},
      {"natural=water water=river", LandCoverClass::kRiver},
      {"waterway=riverbank", LandCoverClass::kRiver},
      {"landuse=reservoir", LandCoverClass::kPond},
      {"landuse=basin", LandCoverClass::kPond},
      {"leisure=swimming_pool", LandCoverClass::kPool},
      {"aeroway=apron", LandCoverClass::kApron},
      {"railway=platform", LandCoverClass::kPlatform},
  };
  for (const auto& c : cases) {
    const Features features = features_of(std::string("a1 0:0 40:0 40:30 0:30 ") + c.tags);
    ASSERT_EQ(features.areas.size(), 1u) << c.tags;
    EXPECT_EQ(values_of(features.areas[0].surface).name, values_of(c.surface).name) << c.tags;
  }
}

TEST(LocateAreas, WaterFromTwoHectaresOnIsALake) {
  for (const auto& [tags, surface] : {std::pair{"natural=water", LandCoverClass::kLake},
                                      {"landuse=reservoir", LandCoverClass::kReservoir},
                                      {"landuse=basin", LandCoverClass::kBasin}}) {
    EXPECT_EQ(features_of(std::string("a1 0:0 200:0 200:101 0:101 ") + tags).areas.at(0).surface, surface) << tags;
    EXPECT_EQ(features_of(std::string("a1 0:0 200:0 200:99 0:99 ") + tags).areas.at(0).surface, LandCoverClass::kPond);
  }
}

TEST(LocateAreas, ARoundaboutIsNoSquare) {
  const Features features = features_of("a1 0:0 40:0 40:30 0:30 highway=residential junction=roundabout");
  EXPECT_TRUE(features.areas.empty());
  EXPECT_EQ(features.tracks.size(), 1u);
}

TEST(LocateAreas, RingsRunCounterClockwiseAndHolesClockwise) {
  const Features features =
      features_of("r1 0:0 90:0 90:90 0:90 / 10:10 10:20 20:20 20:10 / 40:40 40:60 60:60 natural=water");
  ASSERT_EQ(features.areas.size(), 1u);
  EXPECT_GT(signed_area_m2(features.areas[0].polygon.outer), 0);
  ASSERT_EQ(features.areas[0].polygon.holes.size(), 2u);
  for (const Ring& hole : features.areas[0].polygon.holes) EXPECT_LT(signed_area_m2(hole), 0);
}

// Lake Michigan in Chicago's extract, r1205149; broken/osm2world-huge_areas.osm.
TEST(LocateAreas, ALakeThatReachesFarOutIsKeptNearAndCoversTheSamePlaces) {
  const Features features = features_of("a1 0:0 500000:-300000 700000:400000 -20:600000 natural=water");
  ASSERT_EQ(features.areas.size(), 1u);
  const AreaFeature& lake = features.areas[0];
  const Box2 far = features.extent.widened(70000);
  for (const Vec2 p : lake.polygon.outer) EXPECT_TRUE(far.contains(p)) << p.x << " " << p.y;
  EXPECT_TRUE(contains(lake.polygon, {300, 100}));
  EXPECT_FALSE(contains(lake.polygon, {-300, 100}));
  EXPECT_FALSE(contains(lake.polygon, {300, -400}));
  // its rank among overlapping polygons is that of the whole polygon
  EXPECT_GT(lake.area_m2, 1e11);
}

TEST(LocateAreas, WhatIsDroppedIsCounted) {
  Report report;
  const Features features = features_of(R"(
    a1 0:0 40:0 40:30 landuse=grass
    a2 0:0 40:0 40:30 landuse=unheard_of
    a3 5000:0 5040:0 5040:30 landuse=grass
    a4 0:0 40:0 40:30 natural=water location=underground
    a5 7:7 7:7 7:7 landuse=grass
    a6 0:0 40:0 40:30 name=nothing)",
                                        report);
  EXPECT_EQ(features.areas.size(), 1u);
  const Account& account = report.account("map", "area");
  EXPECT_EQ(account.in, 4u);
  for (const Code code : {Code::kOutsideBounds, Code::kUnderground, Code::kDegenerateRing})
    EXPECT_EQ(account.dropped.at(code), 1u) << name_of(code);
  EXPECT_TRUE(report.balances());
}

double area_of(const std::string& text) {
  const Features features = features_of(text);
  EXPECT_EQ(features.areas.size(), 1u) << text;
  return features.areas.empty() ? 0 : area_m2(features.areas[0].polygon);
}

TEST(LocateAreas, AClosedTrackIsARingOfItsWidth) {
  const std::string line = "a1 0:0 100:0 100:60 0:60 leisure=track";
  EXPECT_NEAR(area_of(line + " sport=running"), 320 * 7.5, 1);
  EXPECT_NEAR(area_of(line + " width=4"), 320 * 4, 1);
  EXPECT_NEAR(area_of(line + " lanes=4"), 320 * 4 * 1.22, 1);
  EXPECT_NEAR(area_of(line + " area=yes"), 6000, 1) << "an area is its own outline";
  EXPECT_NEAR(area_of("a1 0:0 100:0 100:8 0:8 leisure=track"), 800, 1) << "as narrow as a track: its outline";
  EXPECT_NEAR(area_of("r1 0:0 100:0 100:60 0:60 / 8:8 8:52 92:52 92:8 leisure=track"), 6000 - 84 * 44, 1);
  EXPECT_TRUE(features_of("a1 0:0 100:0 100:60 0:60 leisure=track sport=skiing").areas.empty());
}

TEST(LocateAreas, ACarParkThatIsABuildingIsNotInsideOne) {
  Report report;
  const Features features = features_of(R"(
    a1 0:0 40:0 40:30 building=parking amenity=parking parking=multi-storey
    a2 60:0 99:0 99:30 amenity=parking parking=multi-storey)",
                                        report);
  EXPECT_EQ(features.footprints.size(), 1u);
  EXPECT_EQ(report.account("map", "area").merged, 1u);
  EXPECT_EQ(report.counts()[Code::kInsideBuilding], 1u) << "of the second, which is no building";
  EXPECT_TRUE(report.balances());
}

}  // namespace
}  // namespace citykiln::map

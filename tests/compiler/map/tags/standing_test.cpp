#include "compiler/map/tags/standing.h"

#include <gtest/gtest.h>

#include "compiler/map/buildings/building_classes.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

std::uint64_t dropped(const std::string& tags, Code code) {
  Report report;
  features_of("a1 0:0 16:0 16:12 0:12 " + tags, report);
  EXPECT_TRUE(report.balances()) << tags;
  const auto counts = report.counts();
  const auto found = counts.find(code);
  return found == counts.end() ? 0 : found->second;
}

TEST(Standing, LevelsAreNumbersListsAndRanges) {
  const struct {
    const char* text;
    double lowest, highest;
  } rows[] = {{"-1", -1, -1}, {"0;1", 0, 1}, {"-2--1", -2, -1}, {"1-3", 1, 3}, {"0.5", 0.5, 0.5}, {"-1; 0", -1, 0}};
  for (const auto& row : rows) {
    const auto levels = levels_of(row.text);
    ASSERT_TRUE(levels) << row.text;
    EXPECT_EQ(levels->lowest, row.lowest) << row.text;
    EXPECT_EQ(levels->highest, row.highest) << row.text;
  }
  for (const char* text : {"", "ground", "1-", "1;x", "B1"}) EXPECT_FALSE(levels_of(text)) << text;
}

TEST(Standing, BuildingsThatAreGoneAreNotBuilt) {
  for (const char* tags : {"building=demolished", "building=razed", "building=destroyed", "building=collapsed",
                           "building=proposed", "building=yes demolished=yes", "building=yes removed=yes",
                           "building=yes end_date=1990", "building=yes start_date=2990"})
    EXPECT_EQ(dropped(tags, Code::kNotThere), 1u) << tags;
  for (const char* tags : {"building=yes", "building=yes disused=yes", "building=yes demolished=no",
                           "building=yes end_date=2990", "disused:building=house", "abandoned:building=yes"})
    EXPECT_EQ(features_of(std::string("a1 0:0 16:0 16:12 0:12 ") + tags).footprints.size(), 1u) << tags;
  for (const char* tags : {"demolished:building=yes", "razed:building=yes", "was:building=yes"})
    EXPECT_TRUE(features_of(std::string("a1 0:0 16:0 16:12 0:12 ") + tags).footprints.empty()) << tags;
}

TEST(Standing, RuinsAndConstructionAreShellsWithoutARoof) {
  for (const char* tags : {"building=ruins", "building=yes ruins=yes", "building=construction construction=apartments",
                           "construction:building=yes", "building=castle historic=ruins"}) {
    const Features features = features_of(std::string("a1 0:0 16:0 16:12 0:12 roof:shape=hipped ") + tags);
    ASSERT_EQ(features.footprints.size(), 1u) << tags;
    const Footprint& shell = features.footprints[0];
    EXPECT_NEAR(area_m2(shell.polygon), 16 * 12 - 15 * 11, 0.1) << tags;
    EXPECT_EQ(shell.roof.form, roofs::RoofForm::kFlat) << tags;
    EXPECT_EQ(shell.building_class, static_cast<std::uint8_t>(BuildingClass::kShell)) << tags;
  }
  EXPECT_NEAR(features_of("a1 0:0 16:0 16:12 0:12 building=ruins").footprints[0].height_m, 3, 1e-9);
  EXPECT_NEAR(
      features_of("a1 0:0 16:0 16:12 0:12 building=construction construction=apartments").footprints[0].height_m, 14,
      1e-9);
}

TEST(Standing, BuildingsBelowTheGroundAreNotBuilt) {
  for (const char* tags :
       {"building=yes level=-1", "building=yes location=underground", "building=yes layer=-1",
        "building=yes tunnel=yes", "building=yes building:levels=0 building:levels:underground=2",
        "building=yes building:min_level=-2 building:levels=2", "building:part=yes level=-1 height=3"})
    EXPECT_EQ(dropped(tags, Code::kUnderground), 1u) << tags;
  for (const char* tags :
       {"building=yes layer=-1 building:levels=3", "building=roof layer=-1", "building=yes level=-1;0",
        "building=yes level=2", "building=yes location=roof", "building=yes building:levels=0"})
    EXPECT_EQ(dropped(tags, Code::kUnderground), 0u) << tags;
  EXPECT_EQ(dropped("building:part=yes indoor=yes level=0", Code::kInsideBuilding), 1u);
}

TEST(Standing, PlatformsPoolsAndPitchesAreOnTheirOwnStorey) {
  for (const char* tags : {"railway=platform layer=-1", "railway=platform level=-2", "leisure=pitch level=-1",
                           "amenity=parking parking=underground", "natural=water location=underground"})
    EXPECT_EQ(dropped(tags, Code::kUnderground), 1u) << tags;
  for (const char* tags : {"railway=platform layer=1", "leisure=pitch level=3", "leisure=swimming_pool location=roof",
                           "leisure=garden level=2"})
    EXPECT_EQ(dropped(tags, Code::kAboveGround), 1u) << tags;
  EXPECT_EQ(dropped("leisure=swimming_pool indoor=yes", Code::kInsideBuilding), 1u);
  for (const char* tags : {"natural=water layer=-1", "landuse=grass layer=1", "railway=platform level=0",
                           "leisure=pitch layer=0", "railway=platform level=0 indoor=yes"})
    EXPECT_EQ(features_of(std::string("a1 0:0 16:0 16:12 0:12 ") + tags).areas.size(), 1u) << tags;
}

TEST(Standing, WaysThatAreGoneOrNotFinishedAreNamedAsSuch) {
  for (const char* tags : {"highway=proposed", "railway=razed", "highway=construction construction=primary",
                           "railway=dismantled", "highway=residential demolished=yes"}) {
    Report report;
    EXPECT_TRUE(features_of(std::string("w1 0:0 90:0 ") + tags, report).tracks.empty()) << tags;
    EXPECT_EQ(report.counts()[Code::kNotThere], 1u) << tags;
  }
  EXPECT_EQ(features_of("w1 0:0 90:0 highway=footway level=-1").tracks[0].passage, Passage::kTunnel);
  EXPECT_EQ(features_of("w1 0:0 90:0 highway=residential construction=yes").tracks.size(), 1u);
}

TEST(Standing, BarriersAndTreesOnOtherStoreysAreNotOnTheGrass) {
  const Features features = features_of(
      "w1 0:0 9:0 barrier=wall level=-1\nw2 0:3 9:3 barrier=fence location=roof\nn3 5:5 natural=tree level=2\n"
      "w4 0:9 9:9 barrier=wall\nn5 9:9 natural=tree\nw6 0:20 90:20 waterway=stream location=underground");
  EXPECT_EQ(features.barriers.size(), 1u);
  EXPECT_EQ(features.points.size(), 1u);
  ASSERT_EQ(features.waterways.size(), 1u);
  EXPECT_EQ(features.waterways[0].passage, Passage::kTunnel);
}

}  // namespace
}  // namespace citykiln::map

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/derived_id.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/buildings/uncovered_pieces.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

using materials::Material;

Footprint footprint_of(const std::string& tags) {
  const Features features = features_of("a1 0:0 12:0 12:9 0:9 " + tags);
  EXPECT_EQ(features.footprints.size(), 1u) << tags;
  return features.footprints.empty() ? Footprint{} : features.footprints[0];
}

TEST(LocateFootprints, HeightComesFromTagsElseLevelsElseClass) {
  const struct {
    const char* tags;
    double height_m, min_height_m;
  } cases[] = {
      {"building=yes height=12~m", 12, 0},
      {"building=yes height=40'", 12.192, 0},
      {"building=yes height=423.4", 423.4, 0},
      {"building:part=yes height=0.36", 0.36, 0},  // a step of the Siegessäule, w131446869
      {"building=apartments building:levels=5", 15, 0},
      {"building=apartments building:levels=5 roof:levels=1", 15, 0},
      {"building=apartments building:levels=5 roof:height=2", 15, 0},
      {"building=yes building:levels=4 height=20", 20, 0},
      {"building:part=yes height=30 min_height=10", 30, 10},
      {"building:part=apartments height=30 building:min_level=2", 30, 6},
      {"building=yes roof:levels=2", 7.5, 0},  // the walls of its class
      {"building=house roof:shape=hipped roof:height=3", 7, 0},
      {"building=house building:levels=0 roof:levels=2", 0.25, 0},
      {"building=yes height=12 building:levels=3 building:min_level=1", 12, 4},
      // a height below min_height is that of the part; an equal one is the place of a slab or a storey
      {"building:part=yes height=5 min_height=9", 14, 9},
      {"building:part=roof height=146 min_height=146", 146.25, 146},
      // a skywalk without min_height begins over the traffic
      {"building=bridge", 8.1, 5},
      {"building=skyway building:levels=2", 11.2, 5},
      {"building=bridge height=9", 9, 5},
      {"building=bridge min_height=7 height=12", 12, 7},
      {"building=church building:part=yes min_height=18 roof:shape=dome roof:height=5", 19, 18},
      {"building:part=apartments building:levels=1 building:min_level=3", 12, 9},
      {"building:part=apartments building:levels=2 building:min_level=2", 9, 6},
      {"building:part=yes height=900 min_height=990", 900, 0},
      {"building=church height=tall min_height=30", 16, 0},
      {"building=garage", 2.75, 0},
      {"building=church", 16, 0},
      {"building=yes", 7.5, 0},  // 108 m²
  };
  for (const auto& c : cases) {
    const Footprint footprint = footprint_of(c.tags);
    EXPECT_NEAR(footprint.height_m, c.height_m, 0.0005) << c.tags;
    EXPECT_NEAR(footprint.min_height_m, c.min_height_m, 0.0005) << c.tags;
  }
}

TEST(LocateFootprints, HeightExceedsMinHeight) {
  for (const char* tags : {"building=yes height=5 min_height=5", "building=yes height=5 min_height=9",
                           "building=yes height=-3", "building=yes height=0", "building=yes building:levels=0",
                           "building=yes height=1e9", "building:part=yes height=0.1 min_height=0.0999",
                           "building=yes building:levels=-2", "building=yes building:min_level=3"}) {
    const Footprint footprint = footprint_of(tags);
    EXPECT_GT(footprint.height_m, footprint.min_height_m) << tags;
    EXPECT_GE(footprint.min_height_m, 0) << tags;
  }
}

TEST(LocateFootprints, BadValuesAreDiagnosed) {
  for (const char* bad : {"height=tall", "building:levels=7-7", "building:colour=reddish", "roof:colour=#12",
                          "min_height=low", "height=5000", "roof:shape=gabeld", "roof:direction=up", "roof:angle=95",
                          "start_date=old", "roof:height=tall"}) {
    Report report;
    features_of(std::string("a1 0:0 12:0 12:9 0:9 building=yes ") + bad, report);
    EXPECT_EQ(report.counts()[Code::kBadTagValue], 1u) << bad;
    const auto found = std::ranges::find(report.diagnoses(), Code::kBadTagValue, &Diagnosis::code);
    ASSERT_NE(found, report.diagnoses().end());
    EXPECT_EQ(found->tag, bad);
  }
}

TEST(LocateFootprints, ColoursMaterialsAndClassAreRead) {
  const Footprint f = footprint_of(
      "building=church building:colour=#804020 roof:color=red building:material=brick roof:material=slate");
  EXPECT_EQ(f.wall_colour, (Srgb{0x80, 0x40, 0x20}));
  EXPECT_TRUE(f.roof_colour.has_value());
  EXPECT_EQ(f.wall_material, Material::kBrick);
  EXPECT_EQ(f.roof_material, Material::kSlate);
  EXPECT_EQ(f.building_class, static_cast<std::uint8_t>(BuildingClass::kChurch));
  EXPECT_FALSE(footprint_of("building=yes").wall_material.has_value());
  const Footprint silo = footprint_of("building=silo building:material=stainless_steel roof:material=aluminium");
  EXPECT_EQ(silo.wall_material, Material::kBareMetal);
  EXPECT_EQ(silo.roof_material, Material::kBareMetal);
}

TEST(LocateFootprints, RoofsAreReadAsSimple3DBuildingsHasThem) {
  using roofs::RoofForm;
  const Footprint f = footprint_of(
      "building=house roof:shape=half-hipped roof:height=3.5 roof:angle=40 roof:direction=SW roof:orientation=across");
  EXPECT_TRUE(f.has_roof_shape);
  EXPECT_EQ(f.roof.form, RoofForm::kHalfHipped);
  EXPECT_EQ(f.roof.height_m, 3.5);
  EXPECT_EQ(f.roof.angle_deg, 40);
  EXPECT_TRUE(f.roof.is_ridge_across);
  ASSERT_TRUE(f.roof.direction);
  EXPECT_NEAR(f.roof.direction->x, -std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(f.roof.direction->y, -std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(footprint_of("building=yes roof:levels=2").roof.height_m, 6.2, 1e-9);
  EXPECT_FALSE(footprint_of("building=yes roof:shape=many").has_roof_shape);
  EXPECT_TRUE(footprint_of("building=yes height=9").has_roof_in_height);
  EXPECT_FALSE(footprint_of("building=yes building:levels=2").has_roof_in_height);
}

TEST(LocateFootprints, AgeAndShopsAreRead) {
  EXPECT_EQ(footprint_of("building=yes start_date=~1904").year, 1904);
  EXPECT_TRUE(footprint_of("building=yes shop=bakery").has_shop);
  EXPECT_TRUE(footprint_of("building=yes amenity=pub").has_shop);
  EXPECT_FALSE(footprint_of("building=yes amenity=parking").has_shop);
}

TEST(LocateFootprints, AnOutlineCoveredByItsPartsIsMarked) {
  const Features features = features_of(R"(
    a1 0:0 40:0 40:20 0:20 building=yes
    a2 0:0 20:0 20:20 0:20 building:part=yes height=30
    a3 20:0 40:0 40:20 20:20 building:part=yes height=10
    a6 200:0 220:0 220:20 200:20 building=yes)");
  ASSERT_EQ(features.footprints.size(), 4u);
  EXPECT_TRUE(features.footprints[0].has_parts);
  EXPECT_TRUE(features.footprints[1].is_part);
  EXPECT_FALSE(features.footprints[1].has_parts);
  EXPECT_FALSE(features.footprints[3].has_parts);
}

// The footprints that are built.
std::vector<Footprint> built(const std::string& text, Report& report) {
  std::vector<Footprint> footprints = features_of(text, report).footprints;
  std::erase_if(footprints, [](const Footprint& f) { return f.has_parts; });
  EXPECT_TRUE(report.balances());
  return footprints;
}

double total_area_m2(const std::vector<Footprint>& footprints) {
  double sum_m2 = 0;
  for (const Footprint& f : footprints) sum_m2 += area_m2(f.polygon);
  return sum_m2;
}

TEST(LocateFootprints, StepsBelowAnOutlineDoNotReplaceIt) {
  Report report;
  // a monument, as w56226088 of Berlin: steps, the base as outline, a drum on it
  const std::vector<Footprint> footprints = built(R"(
    a1 2:2 18:2 18:18 2:18 building=yes min_height=1.8 height=9.2
    a2 0:0 20:0 20:20 0:20 building:part=yes height=1.8 roof:shape=flat
    a3 4:4 16:4 16:16 4:16 building:part=yes min_height=9.2 height=18)",
                                                  report);
  ASSERT_EQ(footprints.size(), 3u);
  EXPECT_EQ(footprints[0].id.osm.id, 1);
  EXPECT_NEAR(area_m2(footprints[0].polygon), 256, 0.1);
}

TEST(LocateFootprints, WhatNoPartCoversKeepsTheOutlinesHeightAndRoof) {
  Report report;
  const auto f = built(R"(
    a1 0:0 40:0 40:12 0:12 building=apartments building:levels=6 roof:shape=hipped
    a2 0:0 12:0 12:12 0:12 building:part=yes building:levels=5
    a3 28:0 40:0 40:12 28:12 building:part=yes building:levels=5)",
                       report);
  ASSERT_EQ(f.size(), 3u);
  EXPECT_EQ(f[0].id, piece_id({{OsmType::kWay, 1}, 0}, 0));
  EXPECT_EQ(f[0].height_m, 18);
  EXPECT_EQ(f[0].roof.form, roofs::RoofForm::kHipped);
  EXPECT_EQ(f[0].outline, (ObjectId{{OsmType::kWay, 1}, 0}));
  EXPECT_NEAR(area_m2(f[0].polygon), 16 * 12, 0.5);
  EXPECT_EQ(f[1].height_m, 15);
  EXPECT_NEAR(total_area_m2(f), 480, 0.5);
}

TEST(LocateFootprints, ACoveredMiddleLeavesTwoPieces) {
  Report report;
  const auto f = built(R"(
    a1 0:0 30:0 30:12 0:12 building=yes building:levels=3
    a2 12:0 18:0 18:12 12:12 building:part=yes building:levels=3 building:min_level=1)",
                       report);
  ASSERT_EQ(f.size(), 3u);
  EXPECT_NE(f[0].id, f[1].id);
  EXPECT_NEAR(f[2].min_height_m, 3.1, 0.001);
  EXPECT_NEAR(total_area_m2(f), 360, 0.5);
}

TEST(LocateFootprints, APartOnTheEavesCoversNothing) {
  Report report;
  const auto f = built(R"(
    a1 0:0 30:0 30:12 0:12 building=yes height=10 roof:shape=flat
    a2 12:2 18:2 18:8 12:8 building:part=yes min_height=10 height=13)",
                       report);
  ASSERT_EQ(f.size(), 2u);
  EXPECT_NEAR(area_m2(f[0].polygon), 360, 0.5);
}

TEST(LocateFootprints, APartThatReachesOutIsBuiltWhole) {
  Report report;
  const auto f = built(R"(
    a1 0:0 20:0 20:12 0:12 building=yes height=10
    a2 -1.5:3 8:3 8:9 -1.5:9 building:part=yes height=15)",
                       report);
  ASSERT_EQ(f.size(), 2u);
  EXPECT_EQ(f[1].min_height_m, 0);
  EXPECT_NEAR(area_m2(f[1].polygon), 57, 0.5);
  EXPECT_NEAR(area_m2(f[0].polygon), 240 - 48, 0.5);
}

TEST(LocateFootprints, StripsBetweenOutlineAndPartsAreNotBuilt) {
  Report report;
  const auto f = built(R"(
    a1 0:0 40:0 40:12 0:12 building=yes height=20
    a2 0.1:0.1 20:0.1 20:11.9 0.1:11.9 building:part=yes height=9
    a3 20:0.1 30:0.1 30:11.9 20:11.9 building:part=yes height=12)",
                       report);
  ASSERT_EQ(f.size(), 3u);
  EXPECT_NEAR(area_m2(f[0].polygon), 120, 1);
  EXPECT_GT(box_of(f[0].polygon.outer).min.x, 29.5);
}

TEST(LocateFootprints, PartsHaveTheHeightAndTheStoreysOfTheirBuilding) {
  Report report;
  const auto f = built(R"(
    a1 0:0 40:0 40:12 0:12 building=yes height=20 building:levels=5 roof:shape=flat
    a2 0:0 10:0 10:12 0:12 building:part=yes
    a3 10:0 20:0 20:12 10:12 building:part=yes building:levels=3
    a4 20:0 40:0 40:12 20:12 building:part=yes building:levels=5 building:min_level=2)",
                       report);
  ASSERT_EQ(f.size(), 3u);
  EXPECT_EQ(f[0].height_m, 20);
  EXPECT_TRUE(f[0].has_roof_in_height);
  EXPECT_EQ(f[1].height_m, 12);
  EXPECT_EQ(f[2].min_height_m, 8);
  EXPECT_EQ(f[2].height_m, 20);
  EXPECT_EQ(report.counts()[Code::kNoBuildingHeight], 0u);
}

TEST(LocateFootprints, PartsTakeUseYearColoursAndMaterialsOfTheirBuilding) {
  Report report;
  const std::vector<Footprint> footprints = built(R"(
      a1 0:0 40:0 40:20 0:20 building=church building:material=brick roof:colour=#ff0000 start_date=1890 height=9
      a2 0:0 20:0 20:20 0:20 building:part=yes height=12
      a3 20:0 40:0 40:20 20:20 building:part=garage height=20 building:material=glass roof:colour=#0000ff start_date=1960)",
                                                  report);
  ASSERT_EQ(footprints.size(), 2u);
  const Footprint &plain = footprints[0], &own = footprints[1];
  EXPECT_EQ(plain.building_class, static_cast<std::uint8_t>(building_class_of("church")));
  EXPECT_EQ(plain.wall_material, materials::Material::kBrick);
  EXPECT_EQ(plain.roof_colour, (Srgb{255, 0, 0}));
  EXPECT_EQ(plain.year, 1890);
  EXPECT_EQ(own.building_class, static_cast<std::uint8_t>(building_class_of("garage")));
  EXPECT_NE(own.wall_material, materials::Material::kBrick);
  EXPECT_EQ(own.roof_colour, (Srgb{0, 0, 255}));
  EXPECT_EQ(own.year, 1960);
}

TEST(LocateFootprints, DefaultHeightsAreDiagnosedWhereNoTagCanBeReadAndSomethingIsBuilt) {
  Report report;
  built(R"(
    a1 0:0 10:0 10:10 0:10 building=yes
    a2 20:0 30:0 30:10 20:10 building=yes height=tall
    a3 40:0 50:0 50:10 40:10 building=yes height=tall building:levels=2
    a4 60:0 80:0 80:10 60:10 building=yes
    a5 60:0 70:0 70:10 60:10 building:part=yes height=9 roof:shape=flat
    a8 70:0 80:0 80:10 70:10 building:part=yes height=12 roof:shape=flat
    a6 90:0 99:0 99:10 90:10 building=yes
    a7 90:0 95:0 95:10 90:10 building:part=yes height=9 roof:shape=flat)",
        report);
  std::vector<std::int64_t> ids;
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (diagnosis.code == Code::kNoBuildingHeight) ids.push_back(diagnosis.object.id);
  std::ranges::sort(ids);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{1, 2, 6}));
}

TEST(LocateFootprints, StepsBecomeTreadsDownTheirDirection) {
  Report report;
  const auto f = built(R"(
    a1 0:0 20:0 20:20 0:20 building=yes height=12
    a2 0:4 20:4 20:20 0:20 building:part=yes height=12
    a3 0:0 20:0 20:4 0:4 building:part=steps height=3 roof:shape=skillion roof:direction=180 roof:height=3)",
                       report);
  ASSERT_EQ(f.size(), 1u + 18u);
  double lowest_m = 9, highest_m = 0;
  for (const Footprint& tread : f) {
    if (tread.id.osm.id != 3) continue;
    const double y = box_of(tread.polygon.outer).centre().y;
    // 3 m on 4 m, a tread's top is its upper edge
    EXPECT_NEAR(tread.height_m, (y + 2.0 / 18) * 3 / 4, 0.01);
    lowest_m = std::min(lowest_m, tread.height_m), highest_m = std::max(highest_m, tread.height_m);
  }
  EXPECT_NEAR(lowest_m, 3.0 / 18, 0.001);
  EXPECT_NEAR(highest_m, 3, 0.001);
  EXPECT_NEAR(total_area_m2(f), 400, 0.5);
}

TEST(LocateFootprints, RoofsSheltersAndWhatHasNoWallAreOpen) {
  for (const char* tags : {"building=roof", "building=carport", "building=canopy", "building=pergola",
                           "building:part=roof", "building=yes wall=no", "amenity=shelter", "man_made=canopy",
                           "building=yes amenity=shelter", "railway=platform covered=yes"})
    EXPECT_TRUE(footprint_of(tags).is_open) << tags;
  for (const char* tags :
       {"building=yes", "building=garage", "amenity=shelter shelter_type=basic_hut", "building=hut amenity=shelter"})
    EXPECT_FALSE(footprint_of(tags).is_open) << tags;
  EXPECT_TRUE(features_of("a1 0:0 12:0 12:9 railway=platform").footprints.empty());
}

TEST(LocateFootprints, WhatCarriesABridgeIsNoHouse) {
  Report report;
  EXPECT_TRUE(features_of("a1 0:0 12:0 12:9 building=yes bridge:support=pylon", report).footprints.empty());
  EXPECT_EQ(report.counts()[Code::kBridgeSupport], 1u);
  EXPECT_TRUE(report.balances());
}

TEST(LocateFootprints, AMultipolygonIsOneFootprintAPolygonWithHoles) {
  Report report;
  const Features features =
      features_of("r7 0:0 40:0 40:40 0:40 / 10:10 10:20 20:20 20:10 ; 60:0 70:0 70:9 building=yes height=9", report);
  ASSERT_EQ(features.footprints.size(), 2u);
  EXPECT_EQ(features.footprints[0].id, (ObjectId{{OsmType::kRelation, 7}, 0}));
  EXPECT_EQ(features.footprints[1].id, (ObjectId{{OsmType::kRelation, 7}, 1}));
  EXPECT_EQ(features.footprints[0].polygon.holes.size(), 1u);
  EXPECT_NEAR(area_m2(features.footprints[0].polygon), 1500, 2);
  EXPECT_TRUE(report.balances());
}

TEST(LocateFootprints, BuildingNoIsNoBuilding) {
  EXPECT_TRUE(features_of("a1 0:0 12:0 12:9 building=no").footprints.empty());
  EXPECT_TRUE(features_of("a1 0:0 12:0 12:9 building=yes location=underground").footprints.empty());
}

}  // namespace
}  // namespace citykiln::map

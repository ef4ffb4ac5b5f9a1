#include "compiler/buildings/styles/mixed_styles.h"

#include <gtest/gtest.h>

#include <map>

#include "compiler/buildings/styles/building_materials.h"
#include "compiler/buildings/styles/style.h"
#include "compiler/map/buildings/building_classes.h"
#include "tests/compiler/buildings/made_footprint.h"

namespace citykiln::buildings {
namespace {

using map::BuildingTradition;
using map::CountryGroup;
using materials::Material;

// A building of which some stand in a town.
struct MixedCase {
  CountryGroup country{};
  BuildingTradition tradition{};
  int levels = 5;
  map::BuildingClass building_class = map::BuildingClass::kApartments;
  bool attached = true;
  std::uint16_t year = 0;
  double depth_m = 14;
};

struct MixedBuilding {
  map::Footprint footprint;
  Building building;
};

MixedBuilding mixed_building(const MixedCase& of, std::int64_t id) {
  MixedBuilding b{rectangle(id, {0, 0}, 18, of.depth_m, 3.2 * of.levels), {}};
  b.footprint.country = of.country, b.footprint.tradition = of.tradition;
  b.footprint.building_class = static_cast<std::uint8_t>(of.building_class);
  b.footprint.year = of.year, b.footprint.assumed = bit_of(Assumption::kStyles);
  b.building.id = b.footprint.id, b.building.footprint = b.footprint.polygon;
  b.building.top_m = b.footprint.height_m, b.building.levels = static_cast<std::uint8_t>(of.levels);
  b.building.wall = building_materials(b.footprint, roofs::RoofForm::kFlat).wall;
  if (of.attached) b.building.party_walls = {{.edge = 1, .from_m = 0, .to_m = of.depth_m}};
  return b;
}

// The share of each style among 256 buildings: a sum of 256ths is exact.
std::map<Style, double> shares(const MixedCase& of) {
  std::map<Style, double> shares;
  for (std::int64_t id = 1; id <= 256; ++id) {
    const MixedBuilding b = mixed_building(of, id);
    shares[style_of(b.footprint, b.building)] += 1 / 256.0;
  }
  return shares;
}

TEST(MixedStyles, OfOldBlocksFollowTheTradition) {
  const MixedCase paris{.tradition = BuildingTradition::kFrance, .levels = 6};
  EXPECT_NEAR(shares(paris)[Style::kHaussmann], 0.7, 0.12);
  EXPECT_GT(shares(paris)[Style::kOldTownHouse], 0.1);
  const MixedCase berlin{.tradition = BuildingTradition::kGermany, .levels = 5};
  EXPECT_NEAR(shares(berlin)[Style::kGruenderzeit], 0.82, 0.12);
  const MixedCase nice{.country = CountryGroup::kSouthernEurope, .tradition = BuildingTradition::kFrance, .levels = 5};
  EXPECT_NEAR(shares(nice)[Style::kHaussmann], 0.45, 0.12);
  const MixedCase rome{.country = CountryGroup::kSouthernEurope, .levels = 5};
  EXPECT_EQ(shares(rome)[Style::kMediterraneanHouse], 1);
  const MixedCase zurich{.levels = 5};
  EXPECT_EQ(shares(zurich)[Style::kHaussmann] + shares(zurich)[Style::kGruenderzeit], 0);
}

TEST(MixedStyles, OfOldBlocksFollowTheYear) {
  EXPECT_EQ(shares({.tradition = BuildingTradition::kGermany, .levels = 5, .year = 1895})[Style::kGruenderzeit], 1);
  EXPECT_EQ(shares({.tradition = BuildingTradition::kFrance, .levels = 6, .year = 1880})[Style::kHaussmann], 1);
  EXPECT_EQ(shares({.tradition = BuildingTradition::kFrance, .levels = 6, .year = 1780})[Style::kHaussmann], 0);
  EXPECT_EQ(shares({.tradition = BuildingTradition::kGermany, .levels = 5, .year = 1934})[Style::kGruenderzeit], 0);
}

TEST(MixedStyles, OfOldBlocksHaveMansards) {
  MixedBuilding b = mixed_building({.tradition = BuildingTradition::kFrance, .levels = 5}, 1);
  for (std::int64_t id = 1; id <= 40; ++id) {
    b.footprint.id = b.building.id = {{OsmType::kWay, id}, 0};
    b.building.roof_shape.form = roofs::RoofForm::kMansard;
    EXPECT_EQ(style_of(b.footprint, b.building), Style::kHaussmann);
  }
}

TEST(MixedStyles, OfTowersFollowTheYear) {
  const auto of_year = [](std::uint16_t year) {
    return shares({.country = CountryGroup::kNorthAmerica,
                   .levels = 25,
                   .building_class = map::BuildingClass::kOffice,
                   .attached = false,
                   .year = year});
  };
  EXPECT_NEAR(of_year(1968)[Style::kTower1960], 0.8, 0.12);
  EXPECT_NEAR(of_year(1989)[Style::kTower1990], 0.75, 0.12);
  EXPECT_NEAR(of_year(2016)[Style::kTower2015], 0.85, 0.12);
  std::map<Style, double> unknown = of_year(0);
  for (const Style style : {Style::kTower1960, Style::kTower1990, Style::kTower2015, Style::kGlassTower})
    EXPECT_GT(unknown[style], 0.08) << rule_file_of(style);
}

TEST(MixedStyles, OfTowersKeepTaggedGlass) {
  for (std::int64_t id = 1; id <= 20; ++id) {
    MixedBuilding b = mixed_building({.country = CountryGroup::kNorthAmerica, .levels = 25, .year = 1968}, id);
    b.footprint.wall_material = Material::kGlassFacade, b.building.wall = Material::kGlassFacade;
    EXPECT_EQ(style_of(b.footprint, b.building), Style::kGlassTower);
  }
}

TEST(MixedStyles, OfAsiaAreNarrowAndOfMiddleHeight) {
  const MixedCase narrow{.country = CountryGroup::kJapan, .levels = 6, .depth_m = 9};
  EXPECT_NEAR(shares(narrow)[Style::kAsianMidrise], 0.8, 0.12);
  const MixedCase wide{.country = CountryGroup::kJapan, .levels = 6, .depth_m = 30};
  EXPECT_NEAR(shares(wide)[Style::kAsianMidrise], 0.25, 0.12);
  const MixedCase wide_alone{.country = CountryGroup::kJapan, .levels = 6, .attached = false, .depth_m = 30};
  EXPECT_EQ(shares(wide_alone)[Style::kAsianMidrise], 0);
  EXPECT_EQ(shares({.country = CountryGroup::kJapan, .levels = 2, .depth_m = 9})[Style::kAsianMidrise], 0);
  EXPECT_EQ(shares({.country = CountryGroup::kNorthAmerica, .levels = 6, .depth_m = 9})[Style::kAsianMidrise], 0);
}

TEST(MixedStyles, AreThoseOfAssumedStylesAlone) {
  for (std::int64_t id = 1; id <= 20; ++id) {
    MixedBuilding b = mixed_building({.tradition = BuildingTradition::kGermany, .levels = 5, .year = 1895}, id);
    b.footprint.assumed = kNoAssumptions;
    EXPECT_EQ(style_of(b.footprint, b.building), Style::kOldTownHouse);
  }
}

// Parts of a tower have one style.
TEST(MixedStyles, AreOneForAllPartsOfABuilding) {
  const MixedCase of{.country = CountryGroup::kNorthAmerica, .levels = 25, .attached = false};
  std::map<Style, int> styles;
  for (std::int64_t id = 1; id <= 20; ++id) {
    MixedBuilding b = mixed_building(of, id);
    b.footprint.outline = ObjectId{{OsmType::kWay, 7}, 0};
    ++styles[style_of(b.footprint, b.building)];
  }
  EXPECT_EQ(styles.size(), 1u);
}

TEST(MixedStyles, HaveWallsOfTheirOwn) {
  const MixedBuilding b = mixed_building({.country = CountryGroup::kNorthAmerica, .levels = 25}, 3);
  ASSERT_EQ(building_materials(b.footprint, roofs::RoofForm::kFlat).wall, Material::kGlassFacade);
  const auto wall_of = [&](Style style) { return regional_materials(b.footprint, roofs::RoofForm::kFlat, style).wall; };
  EXPECT_EQ(wall_of(Style::kGlassTower), Material::kGlassFacade);
  for (const Style style : {Style::kTower1960, Style::kTower1990, Style::kTower2015})
    EXPECT_NE(wall_of(style), Material::kGlassFacade) << rule_file_of(style);
}

}  // namespace
}  // namespace citykiln::buildings

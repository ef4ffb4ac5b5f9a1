#include "compiler/buildings/styles/regional_styles.h"

#include <gtest/gtest.h>

#include <set>

#include "compiler/buildings/styles/style.h"

namespace citykiln::buildings {
namespace {

using map::CountryGroup;
using materials::Material;

constexpr Style kDwellings[] = {Style::kVilla, Style::kRowHouse, Style::kOldTownHouse, Style::kCourtyardBlock,
                                Style::kPanelBlock};

TEST(RegionalStyles, OfCentralEuropeAreThoseOfBuildingsWithoutAssumptions) {
  for (const Style usual : kDwellings)
    for (const std::uint8_t levels : {1, 3, 9})
      EXPECT_EQ(regional_style(CountryGroup::kCentralEurope, usual, levels), usual);
  EXPECT_EQ(regional_wall(CountryGroup::kCentralEurope, Style::kVilla, Material::kStone, 50), Material::kStone);
}

TEST(RegionalStyles, DependOnThePlace) {
  EXPECT_EQ(regional_style(CountryGroup::kJapan, Style::kRowHouse, 2), Style::kJapaneseHouse);
  EXPECT_EQ(regional_style(CountryGroup::kJapan, Style::kPanelBlock, 5), Style::kJapaneseApartments);
  EXPECT_EQ(regional_style(CountryGroup::kBritishIsles, Style::kRowHouse, 2), Style::kBritishTerrace);
  EXPECT_EQ(regional_style(CountryGroup::kNorthAmerica, Style::kVilla, 1), Style::kNorthAmericanHouse);
  EXPECT_EQ(regional_style(CountryGroup::kNorthAmerica, Style::kOldTownHouse, 4), Style::kNorthAmericanRow);
  EXPECT_EQ(regional_style(CountryGroup::kSouthernEurope, Style::kPanelBlock, 6), Style::kBalconyFlats);
  EXPECT_EQ(regional_style(CountryGroup::kNorthernEurope, Style::kVilla, 2), Style::kNordicWood);
}

TEST(RegionalStyles, ReplaceDwellingsAlone) {
  for (int group = 0; group < static_cast<int>(CountryGroup::kCount); ++group)
    for (const Style usual : {Style::kPlain, Style::kShop, Style::kChurch, Style::kWarehouse, Style::kGarage})
      EXPECT_EQ(regional_style(static_cast<CountryGroup>(group), usual, 2), usual);
}

TEST(RegionalStyles, HaveWallsAndRoofsOfSeveralMaterials) {
  for (int i = 1; i < static_cast<int>(CountryGroup::kCount); ++i) {
    const auto group = static_cast<CountryGroup>(i);
    std::set<Material> walls;
    for (std::uint32_t draw = 0; draw < 100; ++draw)
      walls.insert(regional_wall(group, regional_style(group, Style::kVilla, 2), Material::kPlaster, draw));
    EXPECT_GE(walls.size(), 2u) << map::name_of(group);
  }
  EXPECT_EQ(regional_roof(CountryGroup::kJapan, 0), Material::kSlate);
  EXPECT_EQ(regional_roof(CountryGroup::kSouthernEurope, 99), Material::kRoofTile);
}

}  // namespace
}  // namespace citykiln::buildings

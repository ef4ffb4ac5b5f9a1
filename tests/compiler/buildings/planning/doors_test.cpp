#include "compiler/buildings/planning/doors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/buildings/generate.h"
#include "compiler/buildings/styles/style.h"
#include "tests/compiler/buildings/made_footprint.h"

namespace citykiln::buildings {
namespace {

using map::PointKind;
using materials::MaterialMesh;

map::PointFeature point(double x, double y, PointKind kind = PointKind::kEntrance) {
  map::PointFeature feature;
  feature.at = {x, y}, feature.kind = kind;
  return feature;
}

const Polygon kHouse{{{0, 0}, {16, 0}, {16, 12}, {0, 12}}, {}};

std::vector<std::uint16_t> doors(const std::vector<map::PointFeature>& points) {
  return mapped_doors_by_edge(kHouse, index_doors(points));
}

Building building_with(const std::vector<std::uint16_t>& doors, Style style = Style::kPlain) {
  Building b;
  b.id = {{OsmType::kWay, 7}, 0};
  b.footprint = kHouse;
  b.top_m = 12, b.levels = 4;
  b.wall = materials::Material::kPlaster, b.roof = materials::Material::kFlatRoof;
  b.style = style;
  for (const std::uint16_t mask : doors) b.facade_edges.push_back({true, 0, mask});
  return b;
}

TEST(Doors, AreInTheWallNearestToTheEntrance) {
  EXPECT_EQ(doors({point(4.5, 0)}), (std::vector<std::uint16_t>{1u << 4, 0, 0, 0}));
  EXPECT_EQ(doors({point(15.2, 3.5)}), (std::vector<std::uint16_t>{0, 1u << 4, 0, 0}));
  EXPECT_EQ(doors({point(4.5, 0), point(12.5, 0.25)}), (std::vector<std::uint16_t>{1u << 4 | 1u << 12, 0, 0, 0}));
}

TEST(Doors, IgnoreDistantPointsAndOtherKinds) {
  EXPECT_EQ(doors({}), std::vector<std::uint16_t>(4));
  EXPECT_EQ(doors({point(8, 6), point(40, 0), point(4, 0, PointKind::kShop)}), std::vector<std::uint16_t>(4));
}

TEST(Doors, AreAtAddressesIfThereIsNoEntrance) {
  const map::PointFeature number = point(4.5, 0, PointKind::kAddress);
  EXPECT_EQ(doors({number}), (std::vector<std::uint16_t>{1u << 4, 0, 0, 0}));
  EXPECT_EQ(doors({number, point(16, 6.1)}), (std::vector<std::uint16_t>{0, 1u << 8, 0, 0}));
}

TEST(Doors, AreWithinASlotOfTheEntrance) {
  for (double x = 0; x <= 16; x += 0.25) {
    const std::vector<Vec2> places = door_positions(building_with(doors({point(x, 0)})));
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].x, std::clamp(x, kMinDoorToCorner_m, 16 - kMinDoorToCorner_m), 0.5 + 1e-9);
    EXPECT_EQ(places[0].y, 0);
  }
}

// A door leaf lies in a niche; no window sill is as low.
TEST(Doors, AreMadeThereByRules) {
  const Rulebook rulebook = parse_rulebook(shipped_rules());
  const auto lowest_niche = [&](double from_m, double to_m, const std::vector<std::uint16_t>& told) {
    Report report;
    double low_m = 9;
    for (const auto& part : generate(building_with(told, Style::kOldTownHouse), rulebook, {1}, 0.01, report).meshes)
      for (const Vec3 p : part.mesh.positions)
        if (p.y > 0.15 && p.y < 0.3 && p.x > from_m && p.x < to_m) low_m = std::min(low_m, p.z);
    return low_m;
  };
  const std::vector<std::uint16_t> left = {1u << 3, 0, 0, 0}, right = {1u << 12, 0, 0, 0};
  // a door stands on a step
  constexpr double kStep_m = 0.2;
  EXPECT_LT(lowest_niche(2, 5, left), kStep_m);
  EXPECT_GT(lowest_niche(5.5, 15, left), kStep_m);
  EXPECT_LT(lowest_niche(11, 14, right), kStep_m);
  EXPECT_GT(lowest_niche(1, 10.5, right), kStep_m);
}

// The lowest point of niches in the south wall between two distances along it: a door reaches down to the floor.
double lowest_niche_m(const std::vector<MaterialMesh>& meshes, double from_m, double to_m) {
  double low_m = 9;
  for (const MaterialMesh& part : meshes)
    for (const Vec3 p : part.mesh.positions)
      if (p.y > 0.15 && p.y < 1.5 && p.x > from_m && p.x < to_m) low_m = std::min(low_m, p.z);
  return low_m;
}

// Within a facade tile of at most 6 m; and not there without a mapped door.
TEST(Doors, AreMadeByEveryStyleThatHasDoors) {
  for (const Style style : {Style::kOldTownHouse,
                            Style::kCourtyardBlock,
                            Style::kRowHouse,
                            Style::kVilla,
                            Style::kPanelBlock,
                            Style::kOfficeSlab,
                            Style::kShop,
                            Style::kWarehouse,
                            Style::kChurch,
                            Style::kBarn,
                            Style::kCastle,
                            Style::kNorthAmericanHouse,
                            Style::kNorthAmericanRow,
                            Style::kJapaneseHouse,
                            Style::kJapaneseApartments,
                            Style::kBritishTerrace,
                            Style::kMediterraneanHouse,
                            Style::kBalconyFlats,
                            Style::kNordicWood,
                            Style::kLatinAmericanHouse,
                            Style::kFlatRoofHouse,
                            Style::kTropicalHouse,
                            Style::kSouthAsianHouse,
                            Style::kChineseSlab,
                            Style::kHaussmann,
                            Style::kGruenderzeit,
                            Style::kAsianMidrise}) {
    const Rulebook rulebook = parse_rulebook(shipped_rules());
    const auto expanded = [&](const std::vector<std::uint16_t>& told) {
      Building building = building_with(told, style);
      building.footprint = {{{0, 0}, {30, 0}, {30, 14}, {0, 14}}, {}};
      building.top_m = 9, building.levels = 3;
      Report report;
      return generate(building, rulebook, {1}, 0.01, report).meshes;
    };
    // a church stands on a plinth
    constexpr double kFoot_m = 0.7;
    const auto left = expanded({1u << 4, 0, 0, 0}), right = expanded({1u << 11, 0, 0, 0});
    EXPECT_LT(lowest_niche_m(left, 5.4, 11.4), kFoot_m) << rule_file_of(style);
    EXPECT_GT(lowest_niche_m(right, 7.4, 9.4), 0.1) << rule_file_of(style);
    EXPECT_LT(lowest_niche_m(right, 18.6, 24.6), kFoot_m) << rule_file_of(style);
    EXPECT_GT(lowest_niche_m(left, 20.6, 22.6), 0.1) << rule_file_of(style);
  }
}

// Upper parts of a stack have no niches at the height of a door leaf.
TEST(Doors, AreNotMadeInLiftedBuildings) {
  int styles_with_rules = 0;
  for (int number = 0; number < static_cast<int>(Style::kCount); ++number) {
    const auto style = static_cast<Style>(number);
    Building building = building_with({0, 0, 0, 0}, style);
    building.footprint = {{{0, 0}, {30, 0}, {30, 14}, {0, 14}}, {}};
    building.top_m = 9, building.levels = 3, building.has_shop = true;
    building.facade_edges[0].faces_street = true;
    const Rulebook rulebook = parse_rulebook(shipped_rules());
    if (!rulebook.contains(style)) continue;
    ++styles_with_rules;
    const auto lowest_m = [&](bool stands_on_ground) {
      building.stands_on_ground = stands_on_ground;
      Report report;
      const std::vector<MaterialMesh> meshes = generate(building, rulebook, {1}, 0.01, report).meshes;
      EXPECT_FALSE(meshes.empty()) << rule_file_of(style);
      return lowest_niche_m(meshes, 1, 29);
    };
    EXPECT_GT(lowest_m(false), 0.35) << rule_file_of(style);
  }
  EXPECT_EQ(styles_with_rules, static_cast<int>(Style::kCount) - 1);
}

}  // namespace
}  // namespace citykiln::buildings

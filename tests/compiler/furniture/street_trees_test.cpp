#include "compiler/furniture/street_trees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace citykiln::furniture {
namespace {

using map::LandCoverClass;
using map::LaneDirection;
using map::LaneKind;

ground::LandCoverPolygon strip_from_to(double low_m, double high_m, LandCoverClass surface) {
  return {{{OsmType::kWay, 7}, 0}, surface, 0, {{{0, low_m}, {1000, low_m}, {1000, high_m}, {0, high_m}}}};
}

// A street along y = 0 with a verge of 2 m and a pavement of 2 m on its left, and houses behind them.
struct LinedStreet {
  std::vector<roads::Road> roads = {street()};
  std::vector<ground::LandCoverPolygon> cover = {strip_from_to(-3, 3, LandCoverClass::kResidentialRoad),
                                                 strip_from_to(3, 7, LandCoverClass::kPavement),
                                                 strip_from_to(9, 20, LandCoverClass::kBuilding)};
  std::vector<plants::Tree> mapped{};
  std::vector<plants::TreeRow> rows{};
  std::vector<props::StreetLamp> lamps{};

  static roads::Road street() {
    roads::Road road;
    road.id = {{OsmType::kWay, 7}, 0};
    road.axis = {{0, 0}, {1000, 0}};
    road.surface = LandCoverClass::kResidentialRoad;
    road.section.lanes = {{LaneKind::kSidewalk, LaneDirection::kBoth, 2, 0, true},
                          {LaneKind::kVerge, LaneDirection::kBoth, 2, 0, true},
                          {LaneKind::kDriving, LaneDirection::kBackward, 3},
                          {LaneKind::kDriving, LaneDirection::kForward, 3}};
    road.section.axis_offset_m = 3;  // from the carriageway's left edge
    return road;
  }

  std::vector<plants::Tree> trees(const Box2& box, std::uint64_t seed) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    const roadside::TileRecipes recipes{.roads = roads,
                                        .junctions = {},
                                        .yards = {},
                                        .plots = {},
                                        .pitches = {},
                                        .trunks = {},
                                        .things = {},
                                        .lamps = lamps,
                                        .barriers = {},
                                        .buildings = {},
                                        .land_cover = index,
                                        .tile_m = 256};
    const auto species = [](Vec2, double street) {
      return plants::species_mix_of(street < 0.5 ? plants::Species::kLime : plants::Species::kMaple);
    };
    return street_trees(recipes, roadside::clear_zones_of(recipes), {.trees = mapped, .rows = rows}, species, seed,
                        box);
  }

  // The trees by the first seed that lines the street.
  std::vector<plants::Tree> lined() const {
    for (std::uint64_t seed = 0; seed < 40; ++seed)
      if (std::vector<plants::Tree> made = trees(kLinedStreet, seed); !made.empty()) return made;
    return {};
  }

  static constexpr Box2 kLinedStreet{{-64, -64}, {1100, 64}};
};

TEST(StreetTrees, StandInTheMiddleOfTheVergeEvery8m) {
  const std::vector<plants::Tree> trees = LinedStreet{}.lined();
  ASSERT_GE(trees.size(), 120u);
  for (std::size_t i = 0; i < trees.size(); ++i) {
    EXPECT_EQ(trees[i].at.y, 4);
    EXPECT_EQ(trees[i].height_m, 10) << "5 m from the wall";
    EXPECT_EQ(trees[i].species_mix, trees[0].species_mix) << "one species a street";
    if (i > 0) {
      EXPECT_EQ(std::abs(trees[i].at.x - trees[i - 1].at.x), 8);
    }
  }
}

TEST(StreetTrees, LineTheShareOfTheTable) {
  int lined = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed)
    lined += LinedStreet{}.trees(LinedStreet::kLinedStreet, seed).empty() ? 0 : 1;
  EXPECT_NEAR(lined / 400.0, 0.30, 0.07);
}

TEST(StreetTrees, OfTilesAreThoseOfTheWhole) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    std::set<std::pair<double, std::uint32_t>> whole, parts;
    for (const plants::Tree& tree : LinedStreet{}.trees(LinedStreet::kLinedStreet, seed))
      whole.emplace(tree.at.x, tree.id.part);
    for (double x = -64; x < 1100; x += 194)
      for (const plants::Tree& tree : LinedStreet{}.trees({{x, -64}, {x + 194, 64}}, seed))
        EXPECT_TRUE(parts.emplace(tree.at.x, tree.id.part).second);
    EXPECT_EQ(parts, whole);
  }
}

TEST(StreetTrees, AreNotNearMappedOnesNorLamps) {
  LinedStreet street;
  street.mapped.push_back({.id = {{OsmType::kNode, 1}, 0}, .at = {200, 5}});
  street.rows.push_back({.id = {{OsmType::kWay, 2}, 0}, .axis = {{500, 5}, {600, 5}}});
  street.lamps.push_back({.at = {820, 4}});
  const std::vector<plants::Tree> trees = street.lined();
  EXPECT_GT(trees.size(), 50u);
  for (const plants::Tree& tree : trees) {
    EXPECT_GE(distance(tree.at, {200, 5}), kMappedStreetTree_m);
    EXPECT_FALSE(tree.at.x > 450 && tree.at.x < 650);
    EXPECT_GE(distance(tree.at, {820, 4}), kTreeFromLamp_m);
  }
}

TEST(StreetTrees, NeedRoomToTheWalls) {
  LinedStreet street;
  street.cover.back() = strip_from_to(6.5, 20, LandCoverClass::kBuilding);
  EXPECT_TRUE(street.lined().empty());
}

}  // namespace
}  // namespace citykiln::furniture

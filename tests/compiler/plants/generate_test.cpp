#include "compiler/plants/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compiler/geometry/snap.h"
#include "compiler/plants/placing/blue_noise.h"
#include "compiler/plants/placing/placing_steps.h"
#include "tests/compiler/plants/made_surfaces.h"

namespace citykiln::plants {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverClass;

map::Heightfield sloping_east(double grade) {
  map::Heightfield field{{-512, -512}, {16, 16}, 65, 65, {}, 0};
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      field.heights.push_back(static_cast<std::int32_t>(grade * (i * 16) / map::kHeightQuantum_m));
  return field;
}

// A wood with a road, a lake and a house.
std::vector<LandCoverPolygon> wooded() {
  return {surface(1, LandCoverClass::kForest, block(-250, -230, 240, 250)),
          surface(2, LandCoverClass::kResidentialRoad, block(-300, -3, 300, 3)),
          surface(3, LandCoverClass::kLake, block(60, 40, 140, 110)),
          surface(4, LandCoverClass::kBuilding, block(-100, 50, -80, 70))};
}

const std::vector<Wood> kWoods = {{{{OsmType::kWay, 1}, 0}, species_mix_of(PlantCommunity::kMixedWood), 95, 15}};
constexpr Box2 kWoodBox = {{-256, -256}, {256, 256}};
constexpr double kWoodLatitude_deg = 42.5;
const climate::ClimateField kWoodClimate = climate::uniform_climate(climate::ClimateClass::kCfb);

// Recipes in the wood above, and their plants in a box.
struct PlantedWood {
  std::vector<Tree> trees;
  std::vector<Wood> woods = kWoods;
  std::vector<Planting> plantings;
  std::vector<TreeRow> rows;
  std::vector<PowerLineCorridor> corridors;
  std::vector<LandCoverPolygon> surfaces = wooded();
  double grade = 0, base_m = 0;

  map::Heightfield heights() const {
    map::Heightfield field = sloping_east(grade);
    for (std::int32_t& height : field.heights) height += static_cast<std::int32_t>(base_m / map::kHeightQuantum_m);
    return field;
  }
  GeneratedPlants all_in(const Box2& box, Report& report) const {
    const ground::LandCoverIndex map = index_land_cover(surfaces, box.widened(kInfluenceRadius_m));
    const ground::GradedTerrain ground(heights());
    return generate({trees, woods, plantings, rows, corridors}, {map, ground, box, 7, kWoodLatitude_deg, kWoodClimate},
                    report);
  }
  PlacedPlants in(const Box2& box, Report& report) const { return all_in(box, report).placed; }
  PlacedPlants in(const Box2& box) const {
    Report ignored;
    return in(box, ignored);
  }
};

PlacedPlants placed_in(const Box2& box, double grade, Report& report, std::span<const Tree> trees = {}) {
  PlantedWood scene;
  scene.grade = grade, scene.trees.assign(trees.begin(), trees.end());
  return scene.in(box, report);
}

std::vector<Placement> sorted_placements(const PlacedPlants& placed) {
  std::vector<Placement> all;
  for (const auto& [prototype, some] : placed) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end(), [](const Placement& a, const Placement& b) { return a.at < b.at; });
  return all;
}

std::size_t count_of(const PlacedPlants& placed, Species species) {
  std::size_t count = 0;
  for (const auto& [prototype, some] : placed)
    if (prototype.species == species) count += some.size();
  return count;
}

double share_of(const PlacedPlants& placed, std::initializer_list<Species> some) {
  double count = 0;
  for (const Species species : some) count += static_cast<double>(count_of(placed, species));
  return count / static_cast<double>(sorted_placements(placed).size());
}

TEST(Generate, KeepsTrunksApartOnTheGround) {
  for (const double grade : {0.0, 1.0}) {
    Report report;
    const auto trees = sorted_placements(placed_in(kWoodBox, grade, report));
    double nearest = 1e9;
    for (std::size_t i = 0; i < trees.size(); ++i)
      for (std::size_t j = i + 1; j < trees.size() && trees[j].at.x < trees[i].at.x + 8; ++j)
        nearest = std::min(nearest, length(trees[j].at - trees[i].at));
    const double spacing_m = density_for(kWoods[0].trees_per_ha).spacing_m;
    EXPECT_GE(nearest, spacing_m - 0.01);
    EXPECT_LT(nearest, spacing_m + 0.4);
  }
}

TEST(Generate, StandsDenserInPlanWhereTheGroundIsSteep) {
  Report report;
  const double flat = static_cast<double>(sorted_placements(placed_in(kWoodBox, 0, report)).size());
  const double steep = static_cast<double>(sorted_placements(placed_in(kWoodBox, 1, report)).size());
  EXPECT_NEAR(steep / flat, std::sqrt(2.0), 0.12);
}

TEST(Generate, IsAsDenseAsTheWoodAsks) {
  const double wood_m2 = 490.0 * 480 - 490 * 8.5 - 82.5 * 72.5 - 22.5 * 22.5;
  const auto trees = static_cast<double>(sorted_placements(PlantedWood{}.in(kWoodBox)).size());
  EXPECT_NEAR(trees / (wood_m2 / 1e4 * kWoods[0].trees_per_ha), 1, 0.03);
}

TEST(Generate, KeepsTrunksClearOfRoadsBuildingsAndWater) {
  Report report;
  const std::vector<LandCoverPolygon> surfaces = wooded();
  const auto map = index_land_cover(surfaces, kWoodBox.widened(8));
  const auto trees = sorted_placements(placed_in(kWoodBox, 0, report));
  ASSERT_FALSE(trees.empty());
  for (const Placement& tree : trees) {
    EXPECT_EQ(land_cover_at(map, in_plan(tree.at)), 0u);
    EXPECT_GE(clearance_m(map, in_plan(tree.at), 50, 4), kTrunkClearance_m);
  }
}

TEST(Generate, PlantsTheSameTreesInHalvesAsInTheWhole) {
  Report report;
  const auto whole = sorted_placements(placed_in(kWoodBox, 0.3, report));
  ASSERT_FALSE(whole.empty());
  for (const double cut : {-128.0, 0.0, 37.0}) {
    auto halves = sorted_placements(placed_in({{-256, -256}, {cut, 256}}, 0.3, report));
    const auto east = sorted_placements(placed_in({{cut, -256}, {256, 256}}, 0.3, report));
    halves.insert(halves.end(), east.begin(), east.end());
    ASSERT_EQ(halves.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_EQ(halves[i].at, whole[i].at);
      EXPECT_EQ(halves[i].scale, whole[i].scale);
      EXPECT_EQ(halves[i].cos_yaw, whole[i].cos_yaw);
    }
  }
}

TEST(Generate, DependsOnNothingBeyondItsInfluenceRadius) {
  const Box2 box = {{-64, -64}, {64, 64}};
  PlantedWood scene;
  scene.grade = 0.1;
  const auto before = sorted_placements(scene.in(box));
  // an obstacle just beyond
  scene.surfaces.push_back(surface(5, LandCoverClass::kBuilding, block(112.5, -200, 230, 200)));
  const auto after = sorted_placements(scene.in(box));
  ASSERT_FALSE(before.empty());
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].at, after[i].at);
}

TEST(Generate, WoodsFollowTheBeltsOfAltitude) {
  PlantedWood scene;
  scene.woods[0].species_mix = species_mix_of(PlantCommunity::kAnyWood);
  scene.base_m = 1000;
  EXPECT_GT(
      share_of(scene.in(kWoodBox), {Species::kOak, Species::kMaple, Species::kLime, Species::kBeech, Species::kBirch}),
      0.6);
  scene.base_m = 1800;
  EXPECT_GT(share_of(scene.in(kWoodBox), {Species::kPine, Species::kFir, Species::kSpruce}), 0.8);
  EXPECT_EQ(count_of(scene.in(kWoodBox), Species::kOak), 0u);
}

TEST(Generate, WoodsAreLowAndThinAtTheTreeLine) {
  PlantedWood scene;
  scene.woods[0].species_mix = species_mix_of(PlantCommunity::kNeedleWood);
  const auto low = sorted_placements(scene.in(kWoodBox));
  scene.base_m = 2400;
  const auto high = sorted_placements(scene.in(kWoodBox));
  EXPECT_LT(high.size(), 0.6 * static_cast<double>(low.size()));
  const auto tallest = [](const auto& trees) { return std::ranges::max(trees, {}, &Placement::scale).scale; };
  EXPECT_LT(tallest(high), 0.6 * tallest(low));
}

TEST(Generate, ReturnsTheTrunksOfSingleTreesAndRowsAlsoBesideTheBox) {
  PlantedWood scene;
  scene.woods.clear();
  scene.trees = {{{{OsmType::kNode, 3}, 0}, {-150, 20}, 12, species_mix_of(Species::kLime)}};
  scene.rows = {{{{OsmType::kWay, 8}, 0}, {{-200, 0}, {-200, 100}}, species_mix_of(Species::kLime), 12, 10}};
  Report report;
  const std::vector<Vec2> trunks = scene.all_in({{-256, -256}, {0, 40}}, report).trunks;
  EXPECT_EQ(std::ranges::count(trunks, Vec2{-150, 20}), 1);
  // none in the road
  for (const double y : {10, 20, 30, 40}) EXPECT_EQ(std::ranges::count(trunks, Vec2{-200, y}), 1) << y;
  EXPECT_EQ(std::ranges::count(trunks, Vec2{-200, 0}), 0);
  EXPECT_EQ(std::ranges::count(trunks, Vec2{-200, 60}), 0);
}

TEST(Generate, WillowsAndPoplarsStandByWater) {
  PlantedWood scene;
  scene.woods[0].species_mix = species_mix_of(PlantCommunity::kBroadWood);
  const ground::LandCoverIndex map = index_land_cover(scene.surfaces, kWoodBox.widened(kInfluenceRadius_m));
  ground::GradingInputs parts{{}, {}, scene.surfaces, kWoodBox};
  const ground::GradedTerrain ground = grade_terrain(scene.heights(), parts);
  Report report;
  const PlacedPlants placed =
      generate({{}, scene.woods, {}, {}, {}}, {map, ground, kWoodBox, 7, kWoodLatitude_deg, kWoodClimate}, report)
          .placed;
  std::size_t by_water = 0, elsewhere = 0;
  for (const auto& [prototype, some] : placed)
    if (prototype.species == Species::kWillow || prototype.species == Species::kPoplar)
      for (const Placement& p : some) {
        const Box2 about_lake = {{46, 26}, {154, 124}};
        ++(about_lake.contains(in_plan(p.at)) ? by_water : elsewhere);
      }
  EXPECT_GT(by_water, 10u);
  EXPECT_LT(elsewhere, 3 * by_water);
}

TEST(Generate, WoodsKeepClearOfMappedTreesRowsAndCorridors) {
  PlantedWood scene;
  scene.trees = {{{{OsmType::kNode, 9}, 0}, {-150, -100}, 18, species_mix_of(Species::kOak)}};
  scene.rows = {{{{OsmType::kWay, 8}, 0}, {{-200, -50}, {-60, -40}}, species_mix_of(Species::kLime), 14, 0}};
  scene.corridors = {{{{OsmType::kWay, 7}, 0}, {{-250, 150}, {240, 190}}, 24}};
  const auto all = sorted_placements(scene.in(kWoodBox));
  const Vec2 along = unit(Vec2{490, 40});
  std::size_t in_row = 0;
  for (const Placement& tree : all) {
    const Vec2 p = in_plan(tree.at);
    if (tree.feature.id == 8) ++in_row;
    if (tree.feature.id != 1) continue;
    EXPECT_GE(distance(p, {-150, -100}), 6.9);
    EXPECT_GE(std::abs(cross(along, p - Vec2{-250, 150})), 12);
    for (const Placement& other : all) EXPECT_GE(distance(p, in_plan(other.at)), other.feature.id == 8 ? 4 : 0);
  }
  EXPECT_GT(in_row, 12u);
}

TEST(Generate, WoodsBesideEachOtherAreOneWood) {
  PlantedWood scene;
  scene.surfaces = {surface(1, LandCoverClass::kForest, block(-250, -230, 0, 250)),
                    surface(2, LandCoverClass::kForest, block(0, -230, 240, 250))};
  scene.woods = {kWoods[0], kWoods[0]};
  scene.woods[1].surface = scene.surfaces[1].id;
  const auto trees = sorted_placements(scene.in(kWoodBox));
  ASSERT_FALSE(trees.empty());
  for (std::size_t i = 0; i < trees.size(); ++i)
    for (std::size_t j = i + 1; j < trees.size() && trees[j].at.x < trees[i].at.x + 7; ++j)
      EXPECT_GE(length(trees[j].at - trees[i].at), density_for(kWoods[0].trees_per_ha).spacing_m - 0.01);
}

TEST(Generate, RowsStandRegularlyAndEndToEnd) {
  PlantedWood scene;
  scene.woods.clear();
  scene.rows = {
      {{{OsmType::kWay, 8}, 0}, {{-250, 20}, {-190, 20}, {-190, 110}}, species_mix_of(Species::kPoplar), 20, 10}};
  auto trees = sorted_placements(scene.in(kWoodBox));
  ASSERT_EQ(trees.size(), 16u);
  std::ranges::sort(trees, {}, [](const Placement& p) { return p.at.x + p.at.y; });
  EXPECT_EQ(in_plan(trees.front().at), (Vec2{-250, 20}));
  EXPECT_EQ(in_plan(trees.back().at), (Vec2{-190, 110}));
  for (std::size_t i = 1; i < trees.size(); ++i) EXPECT_NEAR(length(trees[i].at - trees[i - 1].at), 10, 0.01);
  EXPECT_EQ(count_of(scene.in(kWoodBox), Species::kPoplar), 16u);
  // two tiles share the row
  EXPECT_EQ(sorted_placements(scene.in({{-256, -256}, {-190, 256}})).size() +
                sorted_placements(scene.in({{-190, -256}, {256, 256}})).size(),
            16u);
}

TEST(Generate, RowsLeaveOutRoadsAndTreesThatAreMapped) {
  PlantedWood scene;
  scene.woods.clear();
  scene.trees = {{{{OsmType::kNode, 9}, 0}, {-200, 41}, 12, species_mix_of(Species::kLime)}};
  scene.rows = {{{{OsmType::kWay, 8}, 0}, {{-200, -50}, {-200, 50}}, species_mix_of(Species::kLime), 12, 10}};
  std::size_t of_row = 0;
  for (const Placement& p : sorted_placements(scene.in(kWoodBox))) {
    if (p.feature.id != 8) continue;
    ++of_row;
    EXPECT_GT(std::abs(p.at.y), 3);
    EXPECT_GT(std::abs(p.at.y - 41), 2);
  }
  EXPECT_EQ(of_row, 9u);  // of eleven, one is on the road and one is mapped
}

TEST(Generate, PlantingsAreRowsAlongTheirHeadingInAnyBox) {
  PlantedWood scene;
  scene.woods.clear();
  scene.surfaces[0].surface = LandCoverClass::kOrchard;
  scene.plantings = {{scene.surfaces[0].id, species_mix_of(Species::kApple), 64, 8, 5, 4.5}};  // north-east
  const PlacedPlants whole = scene.in(kWoodBox);
  const auto trees = sorted_placements(whole);
  EXPECT_NEAR(static_cast<double>(trees.size()), (490.0 * 480 - 490 * 8.5 - 82.5 * 72.5 - 22.5 * 22.5) / 40, 150);
  for (const Placement& tree : trees) {
    const double row = cross(Vec2{std::sqrt(0.5), std::sqrt(0.5)}, in_plan(tree.at)) / 8;
    EXPECT_LT(std::abs(row - std::round(row)), 0.06);
    EXPECT_GE(clearance_m(index_land_cover(scene.surfaces, kWoodBox), in_plan(tree.at), 50, 4), kTrunkClearance_m);
  }
  EXPECT_EQ(sorted_placements(scene.in({{-256, -256}, {11, 256}})).size() +
                sorted_placements(scene.in({{11, -256}, {256, 256}})).size(),
            trees.size());
}

TEST(GenerateBlades, AreNoMoreThanTheLimit) {
  PlantedWood scene;
  scene.surfaces[0].surface = LandCoverClass::kFarmland;
  scene.plantings = {{scene.surfaces[0].id, species_mix_of(Species::kWheat), 64, 0.5, 0.375, 0.875}};
  EXPECT_TRUE(sorted_placements(scene.in(kWoodBox)).size() == sorted_placements(PlantedWood{}.in(kWoodBox)).size());
  const ground::LandCoverIndex map = index_land_cover(scene.surfaces, kWoodBox.widened(kInfluenceRadius_m));
  const ground::GradedTerrain ground(scene.heights());
  const PlacedPlants blades =
      generate_blades(scene.plantings, {map, ground, kWoodBox, 7, kWoodLatitude_deg, kWoodClimate});
  const double most = kMostBladesPerKm2 * 0.512 * 0.512;
  EXPECT_LT(static_cast<double>(sorted_placements(blades).size()), 1.05 * most);
  EXPECT_GT(static_cast<double>(sorted_placements(blades).size()), 0.85 * most);
}

TEST(PlaceHedge, PutsPiecesAsLongAsHighAlongTheLine) {
  const PlantedWood scene;
  const ground::LandCoverIndex map = index_land_cover(scene.surfaces, kWoodBox.widened(kInfluenceRadius_m));
  const ground::GradedTerrain ground(scene.heights());
  PlacedPlants placed;
  const Polyline axis = {{-200, 100}, {-188, 100}, {-188, 91}};
  place_hedge(placed, {axis, 1.5, {OsmType::kWay, 6}}, {map, ground, kWoodBox, 7, kWoodLatitude_deg, kWoodClimate});
  ASSERT_EQ(count_of(placed, Species::kHedge), 14u);
  for (const Placement& piece : sorted_placements(placed)) {
    EXPECT_EQ(piece.scale, 1.5);
    const bool is_on_first = std::abs(piece.at.y - 100) < 0.01;
    EXPECT_NEAR(std::abs(is_on_first ? piece.cos_yaw : piece.sin_yaw), 1, 0.01);
  }
}

TEST(PlaceHedge, ClosesAClosedLine) {
  const PlantedWood scene;
  const ground::LandCoverIndex map = index_land_cover(scene.surfaces, kWoodBox.widened(kInfluenceRadius_m));
  const ground::GradedTerrain ground(scene.heights());
  PlacedPlants placed;
  const Polyline axis = {{-200, 100}, {-188, 100}, {-188, 91}, {-200, 91}, {-200, 100}};
  place_hedge(placed, {axis, 1.5, {OsmType::kWay, 6}}, {map, ground, kWoodBox, 7, kWoodLatitude_deg, kWoodClimate});
  // 42 m in pieces of 1.5 m, the last one from (-200, 98.5) to (-200, 100)
  ASSERT_EQ(count_of(placed, Species::kHedge), 28u);
  EXPECT_TRUE(std::ranges::any_of(sorted_placements(placed), [](const Placement& piece) {
    return distance(in_plan(piece.at), {-200, 99.25}) < 0.01;
  }));
}

TEST(Generate, DropsSingleTreesOnBuildingsAndWaterAndBalances) {
  Report report;
  const auto tree = [](std::int64_t id, Vec2 at) {
    return Tree{{{OsmType::kNode, id}, 0}, at, 11, species_mix_of(Species::kOak)};
  };
  const std::vector<Tree> trees = {tree(1, {0, 0}), tree(2, {100, 80}), tree(3, {-90, 60}), tree(4, {-290, 20}),
                                   tree(5, {10, 10})};
  const auto broad = sorted_placements(placed_in({{-256, -64}, {256, 256}}, 0, report, trees));
  EXPECT_EQ(
      std::count_if(broad.begin(), broad.end(), [](const Placement& p) { return p.feature.type == OsmType::kNode; }),
      2);
  EXPECT_EQ(report.counts()[Code::kTreeOnRoad], 2u);
  EXPECT_EQ(report.counts()[Code::kTreeMoved], 1u);
  EXPECT_TRUE(report.balances());
}

TEST(Generate, MovesTreesFromARoadsEdgeBesideIt) {
  Report report;
  // 0.1, 1 and 1.9 m inside the edges at 3 m, and 0.5 m outside
  const double ys[] = {2.9, -2, 1.1, 3.5};
  std::vector<Tree> trees;
  for (const double y : ys)
    trees.push_back({{{OsmType::kNode, static_cast<std::int64_t>(trees.size() + 1)}, 0},
                     {-280, y},
                     11,
                     species_mix_of(Species::kOak)});
  PlantedWood scene;
  scene.trees = trees, scene.woods.clear();
  for (const Placement& p : sorted_placements(scene.in({{-300, -200}, {-256, 200}}, report))) {
    EXPECT_NEAR(p.at.x, -280, 1);
    EXPECT_EQ(p.at.y < 0, ys[p.feature.id - 1] < 0);
    EXPECT_GT(std::abs(p.at.y), 3.3);
    EXPECT_LT(std::abs(p.at.y), 3.8);
  }
  EXPECT_EQ(report.counts()[Code::kTreeMoved], 3u);
  EXPECT_EQ(report.counts()[Code::kTreeOnRoad], 0u);
  EXPECT_TRUE(report.balances());
  // a tree that is moved across a border belongs to the other tile
  Report below, above;
  EXPECT_EQ(sorted_placements(scene.in({{-300, -200}, {-256, 3.3}}, below)).size(), 1u);
  EXPECT_EQ(sorted_placements(scene.in({{-300, 3.3}, {-256, 200}}, above)).size(), 3u);
  EXPECT_TRUE(below.balances() && above.balances());
}

TEST(Generate, StandsTreesOnTheGroundAndTheSnapGrid) {
  Report report;
  const map::Heightfield heights = sloping_east(0.3);
  const auto trees = sorted_placements(placed_in(kWoodBox, 0.3, report));
  ASSERT_FALSE(trees.empty());
  for (const Placement& tree : trees) {
    EXPECT_EQ(tree.at, snapped(tree.at));
    EXPECT_NEAR(tree.at.z, height_m_at(heights, in_plan(tree.at)), 0.0005);
    EXPECT_NEAR(tree.cos_yaw * tree.cos_yaw + tree.sin_yaw * tree.sin_yaw, 1, 1e-12);
    EXPECT_LE(tree.scale, kTallestPlant_m);
  }
}

}  // namespace
}  // namespace citykiln::plants

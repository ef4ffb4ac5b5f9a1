#include "compiler/plants/plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/map/row_direction.h"
#include "compiler/plants/placing/row_heading.h"
#include "compiler/plants/plant_size.h"

namespace citykiln::plants {
namespace {

using map::LandCoverClass;

map::Heightfield sloping_by(Vec2 grade) {
  map::Heightfield field{{-512, -512}, {16, 16}, 65, 65, {}, 0};
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      field.heights.push_back(static_cast<std::int32_t>((grade.x * i + grade.y * j) * 16 / map::kHeightQuantum_m));
  return field;
}

ObjectId way(std::int64_t id) { return {{OsmType::kWay, id}, 0}; }

map::AreaFeature area(std::int64_t id, LandCoverClass surface, const map::PlantTags& growth = {}) {
  return {way(id), {{{0, 0}, {200, 0}, {200, 100}, {0, 100}}, {}}, surface, 20000, growth};
}

Plants planned(const map::Features& features, Report& report, const map::Heightfield& terrain = sloping_by({}),
               std::span<const roads::Road> roads = {}, Assumptions assumed = kAllAssumptions) {
  std::vector<ground::LandCoverPolygon> surfaces;
  for (const map::AreaFeature& a : features.areas) surfaces.push_back({a.id, a.surface, 20000, {a.polygon.outer}});
  return plan(features, surfaces, roads, terrain, report, assumed);
}

TEST(Plan, KeepsEveryTreeWithItsTags) {
  using map::PlantKind;
  map::Features features;
  const auto tree = [&](std::int64_t id, double height_m, const map::PlantTags& growth) {
    features.points.push_back({{{OsmType::kNode, id}, 0}, {1.0 * id, 2}, map::PointKind::kTree, height_m, growth});
  };
  tree(1, 0, {PlantKind::kUnknown, map::LeafType::kNeedle});
  tree(2, 0, {PlantKind::kOak, {}, 9});
  tree(3, 7.5, {PlantKind::kLime, {}, 30, 2, 1900});
  tree(4, 0, {});
  tree(5, 0, {PlantKind::kLime, {}, 0, 0.97});
  tree(6, 0, {PlantKind::kLime, {}, 0, 0, 2020});
  features.points.push_back({{{OsmType::kNode, 9}, 0}, {3, 4}, map::PointKind::kStreetLamp});
  Report report;
  const Plants plants = planned(features, report);
  ASSERT_EQ(plants.trees.size(), 6u);
  EXPECT_EQ(plants.trees[0].species_mix, species_mix_of(PlantCommunity::kNeedleWood));
  EXPECT_EQ(plants.trees[1].species_mix, species_mix_of(Species::kOak));
  EXPECT_EQ(plants.trees[1].height_m, 10);  // crown_share of oaks is 0.9
  EXPECT_EQ(plants.trees[2].height_m, 7.5);
  EXPECT_EQ(plants.trees[3].species_mix, species_mix_of(PlantCommunity::kTownTrees));
  EXPECT_EQ(plants.trees[3].height_m, 0);
  EXPECT_NEAR(plants.trees[4].height_m, 17, 2);
  EXPECT_NEAR(plants.trees[5].height_m, 4.5, 1);
  EXPECT_EQ(report.ledger().at("plants/tree").out, 6u);
  EXPECT_TRUE(report.balances());
}

TEST(Plan, NoTreeIsTallerThanItsSpecies) {
  for (int s = 0; s < static_cast<int>(Species::kCount); ++s) {
    const auto species = static_cast<Species>(s);
    for (const map::PlantTags& growth :
         {map::PlantTags{{}, {}, 60}, map::PlantTags{{}, {}, 0, 20}, map::PlantTags{{}, {}, 0, 0, 900}}) {
      EXPECT_LE(height_from_tags_m(values_of(species), growth), values_of(species).tallest_m);
      EXPECT_GT(height_from_tags_m(values_of(species), growth), 0);
    }
    EXPECT_GT(values_of(species).crown_share, 0) << values_of(species).file;
  }
}

TEST(Plan, WoodsTakeTheirSpeciesFromClassAndGenus) {
  map::Features features;
  features.areas = {area(1, LandCoverClass::kForest), area(2, LandCoverClass::kNeedleLeavedForest),
                    area(3, LandCoverClass::kForest, {map::PlantKind::kPine}), area(4, LandCoverClass::kResidential)};
  Report report;
  const Plants plants = planned(features, report);
  ASSERT_EQ(plants.woods.size(), 4u);
  EXPECT_EQ(plants.woods[0].species_mix, species_mix_of(PlantCommunity::kAnyWood));
  EXPECT_EQ(plants.woods[1].species_mix, species_mix_of(PlantCommunity::kNeedleWood));
  EXPECT_EQ(plants.woods[2].species_mix, species_mix_of(Species::kPine));
  EXPECT_EQ(plants.woods[3].species_mix, species_mix_of(PlantCommunity::kGardenTrees));
}

TEST(Plan, TreesOnLandInTownsAreAssumedWithYards) {
  map::Features features;
  features.areas = {area(1, LandCoverClass::kPark), area(2, LandCoverClass::kResidential)};
  Report report;
  const Plants plants = planned(features, report, sloping_by({}), {}, kNoAssumptions);
  ASSERT_EQ(plants.woods.size(), 1u);
  EXPECT_EQ(plants.woods[0].surface, features.areas[0].id);
}

TEST(Plan, FieldsGrowTheirTaggedCrop) {
  using map::PlantKind;
  map::Features features;
  features.areas = {area(1, LandCoverClass::kFarmland, {PlantKind::kMaize}),
                    area(2, LandCoverClass::kFarmland),
                    area(3, LandCoverClass::kOrchard),
                    area(4, LandCoverClass::kOrchard, {PlantKind::kPalm}),
                    area(5, LandCoverClass::kVineyard, {PlantKind::kVine}),
                    area(6, LandCoverClass::kReedbed),
                    area(7, LandCoverClass::kHedgeArea, {PlantKind::kCypress, map::LeafType::kNeedle})};
  Report report;
  const Plants plants = planned(features, report);
  ASSERT_EQ(plants.plantings.size(), 6u);
  EXPECT_EQ(plants.plantings[0].species_mix, species_mix_of(Species::kMaize));
  EXPECT_EQ(plants.plantings[1].species_mix, species_mix_of(PlantCommunity::kOrchardTrees));
  EXPECT_EQ(plants.plantings[2].species_mix, species_mix_of(Species::kPalm));
  EXPECT_EQ(plants.plantings[3].species_mix, species_mix_of(Species::kVine));
  EXPECT_EQ(plants.plantings[4].species_mix, species_mix_of(Species::kReed));
  EXPECT_EQ(plants.plantings[5].species_mix, species_mix_of(Species::kHedge));
  for (const Planting& planting : plants.plantings) EXPECT_GE(planting.plant_spacing_m, kLeastPlantSpacing_m);
}

TEST(RowHeading, IsPerpendicularToTheSlope) {
  const ground::LandCoverPolygon field{
      way(1), LandCoverClass::kVineyard, 20000, {{{0, 0}, {200, 0}, {200, 100}, {0, 100}}}};
  for (const Vec2 grade : {Vec2{0.2, 0}, Vec2{0, 0.3}, Vec2{0.1, 0.1}, Vec2{-0.05, 0.2}})
    EXPECT_LT(std::abs(dot(map::row_direction(row_heading(field, sloping_by(grade))), unit(grade))), 0.01);
}

TEST(RowHeading, FollowsTheLongestBorderOfLevelFields) {
  const ground::LandCoverPolygon field{
      way(1), LandCoverClass::kVineyard, 20000, {{{0, 0}, {160, 120}, {100, 200}, {-60, 80}}}};
  EXPECT_NEAR(std::abs(dot(map::row_direction(row_heading(field, sloping_by({0.01, 0}))), Vec2{0.8, 0.6})), 1, 0.001);
}

TEST(Plan, StreetsLinedWithTreesHaveRowsBehindTheirKerbs) {
  map::Features features;
  map::Track track;
  track.id = way(1), track.axis = {{0, 0}, {100, 0}}, track.trees = map::TreeSides::kBoth;
  features.tracks = {track};
  features.tree_rows = {{way(2), {{0, 50}, {90, 50}}, 12, 0, {map::PlantKind::kPoplar}}};
  roads::Road road;
  road.id = way(1), road.axis = track.axis, road.section.lanes.resize(2);
  for (map::Lane& lane : road.section.lanes) lane.width_m = 3;
  road.section.axis_offset_m = 3;
  Report report;
  const Plants plants = planned(features, report, sloping_by({}), std::array{road});
  ASSERT_EQ(plants.rows.size(), 3u);
  EXPECT_EQ(plants.rows[0].axis, (Polyline{{0, 4}, {100, 4}}));
  EXPECT_EQ(plants.rows[1].axis, (Polyline{{0, -4}, {100, -4}}));
  EXPECT_EQ(plants.rows[2].species_mix, species_mix_of(Species::kPoplar));
  EXPECT_EQ(plants.rows[2].height_m, 12);
  EXPECT_TRUE(report.balances());
}

}  // namespace
}  // namespace citykiln::plants

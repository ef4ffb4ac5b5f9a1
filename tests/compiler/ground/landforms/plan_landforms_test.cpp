#include "compiler/ground/landforms/plan_landforms.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/ground/landforms/landform_index.h"

namespace citykiln::ground {
namespace {

// 100 m in the south; `rise_m` higher in the north, over a slope of 32 m about y = 0.
map::Heightfield land_with_terrace(double rise_m) {
  map::Heightfield field{{-256, -272}, {32, 32}, 17, 18, {}, 0};
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i)
      field.heights.push_back(
          static_cast<std::int32_t>((field.vertex(i, j).y < 0 ? 100 : 100 + rise_m) / map::kHeightQuantum_m));
  return field;
}

map::Landform line(map::LandformKind kind, double height_m, bool has_height, double width_m) {
  return {{{OsmType::kWay, 1}, 0}, {{-64, 0}, {64, 0}}, kind, height_m, has_height, width_m};
}

// The land at a place with one landform planned.
double planned_height_m(const map::Landform& form, const map::Heightfield& field, Vec2 p, Report& report,
                        std::span<const LandCoverPolygon> waters = {}) {
  map::Features features;
  features.extent = {{-128, -128}, {128, 128}};
  features.landforms = {form};
  const std::vector<Landform> planned = plan_landforms(features, waters, {}, field, report);
  return with_landforms_m(index_landforms(planned), p, map::height_m_at(field, p));
}

TEST(PlanLandforms, AWallHasTheTerracesHeightsOnItsSides) {
  Report report;
  const map::Landform wall = line(map::LandformKind::kWall, 12, true, 0.375);
  EXPECT_NEAR(planned_height_m(wall, land_with_terrace(12), {0, 1}, report), 112, 0.1);
  EXPECT_NEAR(planned_height_m(wall, land_with_terrace(12), {0, -1}, report), 100, 0.1);
}

TEST(PlanLandforms, ALowWallOnASlopeMakesAStepOfItsOwnHeightOnly) {
  Report report;
  const map::Landform wall = line(map::LandformKind::kWall, 2, true, 0.375);
  const auto at = [&](double y) { return planned_height_m(wall, land_with_terrace(12), {0, y}, report); };
  EXPECT_NEAR(at(0.2) - at(-0.2), 2, 0.1);
}

TEST(PlanLandforms, AWallOnLevelGroundMakesNoStepAndIsReportedIfItsHeightIsTagged) {
  Report report;
  const map::Landform wall = line(map::LandformKind::kWall, 3, true, 0.375);
  EXPECT_EQ(planned_height_m(wall, land_with_terrace(0), {0, 1}, report), 100);
  EXPECT_TRUE(std::ranges::any_of(report.diagnoses(), [](const Diagnosis& d) { return d.code == Code::kStepLowered; }));
}

TEST(PlanLandforms, ACliffHasTheRiseThatSlopesBesideItDoNotExplain) {
  Report report;
  const map::Landform cliff = line(map::LandformKind::kStep, 0, false, 1.5);
  EXPECT_NEAR(planned_height_m(cliff, land_with_terrace(40), {0, 2}, report), 140, 0.1);
  EXPECT_NEAR(planned_height_m(cliff, land_with_terrace(40), {0, -2}, report), 100, 0.1);
}

TEST(PlanLandforms, ADykeRisesAboveTheLandBesideItAndADamAboveItsLowestPlace) {
  Report report;
  EXPECT_NEAR(planned_height_m(line(map::LandformKind::kRidge, 4, true, 3), land_with_terrace(0), {0, 0}, report), 104,
              0.01);
  EXPECT_NEAR(planned_height_m(line(map::LandformKind::kDam, 15, true, 4), land_with_terrace(0), {0, 1}, report), 115,
              0.01);
}

TEST(PlanLandforms, APierStandsAboveItsWaterAndIsReportedWithoutWater) {
  Report report;
  LandCoverPolygon lake{.id = {{OsmType::kWay, 9}, 0}, .surface = map::LandCoverClass::kLake, .rings = {}};
  lake.rings = {{{-100, -100}, {100, -100}, {100, 50}, {-100, 50}}}, lake.level_m = 99.5;
  const map::Landform pier = line(map::LandformKind::kDeck, 1.25, false, 3);
  EXPECT_NEAR(planned_height_m(pier, land_with_terrace(0), {0, 0}, report, std::vector{lake}), 100.75, 0.01);
  EXPECT_TRUE(report.diagnoses().empty());
  planned_height_m(pier, land_with_terrace(0), {0, 0}, report);
  EXPECT_TRUE(
      std::ranges::any_of(report.diagnoses(), [](const Diagnosis& d) { return d.code == Code::kPierWithoutWater; }));
}

TEST(PlanLandforms, AWallWithoutAHeightTakesTheStepOfTheGround) {
  Report report;
  const map::Landform wall = line(map::LandformKind::kWall, 1.5, false, 0.375);
  const auto rise_m = [&](double terrace_m) {
    const map::Heightfield land = land_with_terrace(terrace_m);
    return planned_height_m(wall, land, {0, 1}, report) - planned_height_m(wall, land, {0, -1}, report);
  };
  EXPECT_NEAR(rise_m(12), 12, 0.1);
  EXPECT_NEAR(rise_m(1), 1, 0.1) << "no more than the terrain";
  EXPECT_LT(rise_m(40), 18) << "a hillside is no wall";
}

TEST(PlanLandforms, APierInWaterWithoutAHeightStandsAboveTheTerrain) {
  Report report;
  LandCoverPolygon lake{.id = {{OsmType::kWay, 9}, 0}, .surface = map::LandCoverClass::kLake, .rings = {}};
  lake.rings = {{{-100, -100}, {100, -100}, {100, 50}, {-100, 50}}};
  const map::Landform pier = line(map::LandformKind::kDeck, 1.25, false, 3);
  EXPECT_NEAR(planned_height_m(pier, land_with_terrace(0), {0, 0}, report, std::vector{lake}), 101.25, 0.01);
  EXPECT_TRUE(report.diagnoses().empty());
}

}  // namespace
}  // namespace citykiln::ground

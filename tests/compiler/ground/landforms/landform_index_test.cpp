#include "compiler/ground/landforms/landform_index.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/roads/trim.h"

namespace citykiln::ground {
namespace {

// Terraces at 100 m in the south and 112 m in the north; the grid makes a slope of 32 m about y = 0 between them.
map::Heightfield terraces() {
  map::Heightfield field{{-256, -272}, {32, 32}, 17, 18, {}, 0};
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i)
      field.heights.push_back(
          static_cast<std::int32_t>((field.vertex(i, j).y < 0 ? 100 : 112) / map::kHeightQuantum_m));
  return field;
}

Landform made_form(LandformKind kind, Polyline axis, double half_m, Profile profile) {
  Landform form;
  form.id = {{OsmType::kWay, 1}, 0}, form.axis = std::move(axis), form.kind = kind;
  form.left_m = form.right_m = half_m, form.profile = std::move(profile);
  return form;
}

// From west to east, so its left side is the northern one.
Landform wall() {
  return made_form(LandformKind::kStep, {{-100, 0}, {100, 0}}, 0.1875, {{0, 106, 32}, {200, 106, 32}});
}

double height_at(const Landform& form, Vec2 p) {
  const std::vector<Landform> forms = {form};
  return with_landforms_m(index_landforms(forms), p, map::height_m_at(terraces(), p));
}

TEST(LandformIndex, AWallHoldsTheGroundBehindItLevelAndTheGroundBeforeItToo) {
  for (const double away_m : {0.2, 1.0, 4.0, 8.0, 15.0, 20.0}) {
    EXPECT_NEAR(height_at(wall(), {0, away_m}), 112, 0.05) << away_m;
    EXPECT_NEAR(height_at(wall(), {0, -away_m}), 100, 0.05) << away_m;
  }
  EXPECT_NEAR(height_at(wall(), {0, 0}), 106, 0.05);
}

TEST(LandformIndex, AStepEndsWithin8mOfItsFreeEndAndMakesNoJumpThere) {
  for (const double x : {108.5, 120.0})
    for (const double y : {-6.0, 6.0}) EXPECT_EQ(height_at(wall(), {x, y}), map::height_m_at(terraces(), {x, y}));
  for (double x = 100.5; x < 110; x += 0.25)
    EXPECT_NEAR(height_at(wall(), {x, -0.001}), height_at(wall(), {x, 0.001}), 0.05) << x;
}

TEST(LandformIndex, APlaceFartherThanTheReachKeepsItsTerrain) {
  for (const double y : {-33.0, 33.0}) EXPECT_EQ(height_at(wall(), {0, y}), map::height_m_at(terraces(), {0, y}));
}

TEST(LandformIndex, ATrimmedWallGivesTheSameBits) {
  Landform bent = wall();
  bent.axis = {{-160, 0}, {-100, 0}, {-40, 0}, {0, 10}, {40, 0}, {100, 0}, {160, 0}};
  std::vector<Landform> whole = {bent}, trimmed;
  for (const roads::Strip& run :
       roads::trimmed_to(static_cast<const roads::Strip&>(bent), Box2{{-10, -10}, {10, 10}}, kLandformReach_m))
    trimmed.push_back({run, bent.kind});
  ASSERT_LT(trimmed.front().axis.size(), bent.axis.size());
  const LandformIndex of_whole = index_landforms(whole), of_trimmed = index_landforms(trimmed);
  for (double x = -10; x <= 10; x += 0.7)
    for (double y = -10; y <= 10; y += 0.7)
      EXPECT_EQ(with_landforms_m(of_whole, {x, y}, 105), with_landforms_m(of_trimmed, {x, y}, 105));
}

TEST(LandformIndex, ADykeHasItsHeightOnTopAndSlopesOf1To2) {
  const Landform dyke = made_form(LandformKind::kRidge, {{-100, -100}, {100, -100}}, 1.5, {{0, 104, 0}});
  EXPECT_EQ(height_at(dyke, {0, -101}), 104);
  EXPECT_EQ(height_at(dyke, {0, -105.5}), 102);
  EXPECT_EQ(height_at(dyke, {0, -111}), 100);
}

TEST(LandformIndex, TheLandOfAnAreaIsItsDeckAndNeverLowersTheTerrain) {
  const Landform deck =
      made_form(LandformKind::kDeckArea, {{-10, -10}, {10, -10}, {10, 200}, {-10, 200}}, 0, {{0, 103, 0}});
  EXPECT_EQ(height_at(deck, {0, -9}), std::max(103.0, map::height_m_at(terraces(), {0, -9})));
  EXPECT_EQ(height_at(deck, {0, 100}), 112);
}

TEST(LandformIndex, ARoadBeforeAWallDoesNotCutTheGroundBehindIt) {
  roads::Road road;
  road.id = {{OsmType::kWay, 2}, 0}, road.axis = {{-100, -4}, {100, -4}};
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.profile = {{0, 100, 0}, {200, 100, 0}};
  const std::vector<roads::Road> roads = {road};
  const std::vector<Landform> forms = {wall()};
  const GradedTerrain graded = grade_terrain(
      terraces(), {.roads = roads, .streams = {}, .surfaces = {}, .box = {{-64, -64}, {64, 64}}, .landforms = forms});
  EXPECT_NEAR(land_m(graded, {0, 0.5}), 112, 0.1);
  EXPECT_NEAR(land_m(graded, {0, -0.5}), 100, 0.1);
}

}  // namespace
}  // namespace citykiln::ground

#include "compiler/ground/grading/span_influence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::ground {
namespace {

roads::Road road(Polyline axis, double z_m) {
  roads::Road r;
  r.id = {{OsmType::kWay, 1}, 0};
  r.axis = std::move(axis);
  r.surface = map::LandCoverClass::kPrimaryRoad;
  r.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  r.profile = {{0, z_m, 0}};
  return r;
}

map::Heightfield coarsely_sampled_level(double z_m) {
  map::Heightfield field{{-128, -128}, {128, 128}, 3, 3, {}, 0};
  field.heights.assign(9, static_cast<std::int32_t>(z_m / map::kHeightQuantum_m));
  return field;
}

const Box2 kGradedBox{{-128, -128}, {128, 128}};

// Land at 20 m, a road at 10 m from the west to x = 0.
struct Scene {
  std::vector<roads::Road> roads = {road({{-60, 0}, {0, 0}}, 10)}, decks, bores;
  GradedTerrain graded_terrain() const {
    return grade_terrain(coarsely_sampled_level(20), {roads, {}, {}, kGradedBox, false, decks, bores});
  }
};

TEST(SpanInfluenceIndex, LandKeepsBelowDecks) {
  Scene scene;
  scene.decks = {road({{0, 0}, {60, 0}}, 10)};
  const GradedTerrain graded = scene.graded_terrain();
  for (double x = 2; x < 58; x += 1)
    for (const double y : {-3.0, 0.0, 2.5}) EXPECT_LE(land_m(graded, {x, y}), 10 - kDeckClearance_m);
  // at its very end it meets the road
  EXPECT_NEAR(land_m(graded, {0.001, 0}), 10, 0.01);
  EXPECT_EQ(land_m(graded, {30, 30}), 20);
}

TEST(SpanInfluenceIndex, LandCoversBores) {
  Scene scene;
  scene.bores = {road({{0, 0}, {60, 0}}, 10)};
  const GradedTerrain graded = scene.graded_terrain();
  const double roof_m = 10 + bore_height_m(scene.bores[0]) + kBoreCover_m;
  for (double x = 0; x < 60; x += 1)
    for (const double y : {-3.0, 0.0, 2.5}) EXPECT_GE(land_m(graded, {x, y}), roof_m) << x;
  // in front of the mouth the road is in a cutting again
  EXPECT_NEAR(land_m(graded, {-20, 3}), 10, 0.01);
}

TEST(SpanInfluenceIndex, LandIsContinuousAboutMouths) {
  Scene scene;
  scene.bores = {road({{0, 0}, {60, 0}}, 10)}, scene.decks = {road({{-60, 0}, {-100, 0}}, 10)};
  const GradedTerrain graded = scene.graded_terrain();
  constexpr double kStep_m = 0.01, kSteepest = 12;
  for (double x = -90; x < 30; x += 0.37)
    for (double y = -20; y < 20; y += 0.41) {
      const double here = land_m(graded, {x, y});
      EXPECT_LE(std::abs(land_m(graded, {x + kStep_m, y}) - here), kSteepest * kStep_m) << x << " " << y;
      EXPECT_LE(std::abs(land_m(graded, {x, y + kStep_m}) - here), kSteepest * kStep_m) << x << " " << y;
    }
}

TEST(SpanInfluenceIndex, RoadsOverABoreKeepTheirLand) {
  Scene scene;
  scene.bores = {road({{0, 0}, {60, 0}}, 0)};
  scene.roads = {road({{30, -60}, {30, 60}}, 15)};
  const GradedTerrain graded = scene.graded_terrain();
  EXPECT_NEAR(land_m(graded, {33, 0}), 15, 0.01);
}

TEST(SpanInfluenceIndex, MouthsAreOpenAcrossTheRoadAlone) {
  const std::vector<roads::Road> bores = {road({{0, 0}, {60, 0}}, 10)};
  const SpanInfluenceIndex field = index_span_influence(bores);
  EXPECT_EQ(ceiling_in_mouth_m(field, {0, -3}, {0, 3}, 0.25), 15);
  EXPECT_EQ(ceiling_in_mouth_m(field, {60, -3}, {60, 3}, 0.25), 15);
  EXPECT_LT(ceiling_in_mouth_m(field, {-1, 0}, {1, 0}, 0.25), 0);
  EXPECT_LT(ceiling_in_mouth_m(field, {0, 4}, {0, 6}, 0.25), 0);
  EXPECT_LT(ceiling_in_mouth_m(field, {30, -3}, {30, 3}, 0.25), 0);
}

}  // namespace
}  // namespace citykiln::ground

#include "compiler/props/tree_pits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace citykiln::props {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverClass;

LandCoverPolygon surface(std::int64_t id, LandCoverClass kind, Ring ring) {
  const auto area = static_cast<std::uint32_t>(signed_area_m2(ring));
  return {{{OsmType::kWay, id}, 0}, kind, area, {std::move(ring)}};
}

Ring block(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// A carriageway and the pavement beside it, a square, a lawn, gravel, a pedestrian street.
const std::vector<LandCoverPolygon> kSurfaces = {
    surface(1, LandCoverClass::kResidentialRoad, block(-100, -4, 100, 4)),
    surface(2, LandCoverClass::kPavement, block(-100, 4, 100, 7)),
    surface(3, LandCoverClass::kSquare, block(-100, 40, 0, 90)),
    surface(4, LandCoverClass::kGrass, block(0, 40, 100, 90)),
    surface(5, LandCoverClass::kFootPath, block(-100, -30, 100, -20)),
    surface(6, LandCoverClass::kPedestrianStreet, block(-100, -90, 100, -80))};

roads::Road street_with_axis(Polyline axis, LandCoverClass kind = LandCoverClass::kResidentialRoad) {
  roads::Road road;
  road.axis = std::move(axis), road.surface = kind;
  return road;
}

std::vector<TreePit> pits_at(const std::vector<Vec2>& places, const Polyline& axis = {{-100, 0}, {100, 0}}) {
  const ground::LandCoverIndex map = index_land_cover(kSurfaces, {{-128, -128}, {128, 128}});
  std::vector<Placement> trees;
  for (const Vec2 p : places)
    trees.push_back({at_height(p, 0), 1, 0, 12, {OsmType::kNode, static_cast<std::int64_t>(trees.size() + 1)}});
  return tree_pits(trees, std::vector{street_with_axis(axis)}, map);
}

// A plane that rises to the east.
ground::GradedTerrain sloping(double slope = 1.0 / 16) {
  map::Heightfield field{{-128, -128}, {16, 16}, 17, 17, {}, 0};
  for (int j = 0; j < 17; ++j)
    for (int i = 0; i < 17; ++i)
      field.heights.push_back(static_cast<std::int32_t>(16 * i * slope / map::kHeightQuantum_m));
  return ground::GradedTerrain(std::move(field));
}

TEST(TreePits, AreInPavingAlone) {
  EXPECT_EQ(pits_at({{0, 5.5}}).size(), 1u);
  EXPECT_EQ(pits_at({{-50, 60}}).size(), 1u);
  EXPECT_EQ(pits_at({{0, -85}}).size(), 1u);
  EXPECT_TRUE(pits_at({{50, 60}, {0, -25}, {0, 0}, {0, 20}}).empty());
}

TEST(TreePits, KeepOffTheCarriageway) {
  for (const double y : {4.1, 4.4, 4.6, 4.8, 5.2, 5.5, 6.0, 6.5, 6.9})
    for (const TreePit& pit : pits_at({{0, y}})) {
      EXPECT_GE(pit.at.y - pit.side_m / 2, 4) << y;
      EXPECT_LE(pit.at.y + pit.side_m / 2, 7) << y;
    }
  EXPECT_EQ(pits_at({{0, 5.5}})[0].side_m, 1.5);
  EXPECT_EQ(pits_at({{0, 4.55}})[0].side_m, 1.0);
  EXPECT_TRUE(pits_at({{0, 4.2}}).empty());
}

TEST(TreePits, LieAlongTheNearestRoad) {
  const Vec2 slanting = pits_at({{-50, 60}}, {{-90, 40}, {-20, 110}})[0].along;
  EXPECT_NEAR(slanting.x, std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(slanting.y, std::sqrt(0.5), 1e-9);
  EXPECT_EQ(pits_at({{-50, 80}})[0].along, (Vec2{1, 0}));
}

TEST(TreePits, DoNotTouchEachOther) {
  EXPECT_EQ(pits_at({{-50, 60}, {-49, 60}, {-46, 60}}).size(), 2u);
  EXPECT_EQ(pits_at({{-50, 60}, {-49, 60}})[0].feature, (OsmId{OsmType::kNode, 1}));
}

TEST(TreePits, HaveTheirHeightAsError) {
  const ground::GradedTerrain ground = sloping();
  const TreePit pit = pits_at({{-50, 60}}, {{-90, 40}, {-20, 110}})[0];
  const GeneratedProp full = generate(pit, ground, 0.02), soil = generate(pit, ground, 0.1),
                      none = generate(pit, ground, 0.5);
  EXPECT_EQ(full.error_m, 0);
  EXPECT_TRUE(none.meshes.empty());
  double highest_m = 0, soil_m = 0;
  for (const auto& part : full.meshes)
    for (const Vec3 p : part.mesh.positions) highest_m = std::max(highest_m, p.z - land_m(ground, in_plan(p)));
  for (const Vec3 p : soil.meshes[0].mesh.positions) soil_m = std::max(soil_m, p.z - land_m(ground, in_plan(p)));
  EXPECT_NEAR(none.error_m, highest_m, 0.002);
  EXPECT_NEAR(soil.error_m, highest_m - soil_m, 0.002);
  EXPECT_GT(soil_m, 0.02);
}

TEST(TreePits, AreNotMadeWhereTheGroundIsSteepOrBent) {
  const TreePit pit = pits_at({{-50, 60}})[0];
  EXPECT_TRUE(generate(pit, sloping(0.5), 0.02).meshes.empty());
  // a ridge under it
  map::Heightfield ridge{{-58, -128}, {8, 16}, 17, 17, std::vector<std::int32_t>(289), 0};
  for (int j = 0; j < 17; ++j) ridge.heights[j * 17 + 1] = static_cast<std::int32_t>(1 / map::kHeightQuantum_m);
  EXPECT_TRUE(generate(pit, ground::GradedTerrain(std::move(ridge)), 0.02).meshes.empty());
}

TEST(TreePits, FaceUpwards) {
  const GeneratedProp pit = generate(pits_at({{-50, 60}})[0], sloping(), 0.02);
  double up_m2 = 0;
  for (const auto& part : pit.meshes)
    for (const auto& [a, b, c] : part.mesh.triangles) {
      const auto& p = part.mesh.positions;
      up_m2 += cross(in_plan(p[b] - p[a]), in_plan(p[c] - p[a])) / 2;
    }
  EXPECT_NEAR(up_m2, 1.5 * 1.5, 0.01);
}

}  // namespace
}  // namespace citykiln::props

#include "compiler/structures/stairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

#include "compiler/geometry/snap.h"
#include "tests/compiler/structures/made_spans.h"

namespace citykiln::structures {
namespace {

const Box2 kBox{{-64, -64}, {64, 64}};

// A terrain of a given function, on a grid of 4 m.
map::Heightfield hill(const std::function<double(Vec2)>& height_m) {
  map::Heightfield field{{-128, -128}, {4, 4}, 65, 65, {}, 0};
  for (int j = 0; j < field.rows; ++j)
    for (int i = 0; i < field.columns; ++i)
      field.heights.push_back(
          static_cast<std::int32_t>(std::floor(height_m({-128.0 + 4 * i, -128.0 + 4 * j}) / map::kHeightQuantum_m)));
  return field;
}

roads::Road steps_along(Polyline axis) {
  roads::Road steps;
  steps.id = {{OsmType::kWay, 5}, 0};
  steps.surface = map::LandCoverClass::kSteps;
  steps.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 2}}, 1};
  steps.axis = std::move(axis);
  return steps;
}

struct Built {
  ground::GradedTerrain ground;
  Stairs stairs;
};

Ring ring_of(const Box2& box) { return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}; }

// The way's land cover is a square around it, without what a street covers.
Built built(const roads::Road& steps, const std::function<double(Vec2)>& height_m,
            const Box2& street = {{60, 60}, {62, 62}}) {
  const std::vector<ground::LandCoverPolygon> surfaces = {
      {steps.id, map::LandCoverClass::kSteps, 0, {ring_of(kBox)}},
      {{{OsmType::kWay, 6}, 0}, map::LandCoverClass::kPrimaryRoad, 0, {ring_of(street)}}};
  Built made{ground::grade_terrain(hill(height_m), {{}, {}, surfaces, kBox}), {}};
  made.stairs = stairs_on(steps, ground::index_land_cover(surfaces, kBox), made.ground, kBox);
  return made;
}

std::set<double> tread_heights(const Mesh& mesh) {
  std::set<double> heights;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
    if (p.z == q.z && q.z == r.z && cross(in_plan(q - p), in_plan(r - p)) > 0) heights.insert(p.z);
  }
  return heights;
}

const roads::Road kUp = steps_along({{0, 0}, {20, 0}, {30, 10}});
double ramp_m(Vec2 p) { return 100 + p.x * 0.5 + p.y * 0.25; }

TEST(Stairs, AreClosed) {
  const std::vector<materials::MaterialMesh> meshes = {
      {built(kUp, ramp_m).stairs.mesh, materials::Material::kStone, materials::kNoTint, {}}};
  EXPECT_TRUE(open_edges(meshes).empty());
  EXPECT_GT(volume_m3(meshes), 0);
}

TEST(Stairs, HaveRisersOfOneHeight) {
  const std::set<double> heights = tread_heights(built(kUp, ramp_m).stairs.mesh);
  ASSERT_NEAR(static_cast<double>(heights.size()), (30 * 0.5 + 10 * 0.25) / kRiser_m, 4);
  int double_risers = 0;
  for (auto z = std::next(heights.begin()); z != heights.end(); ++z) {
    const double risers = std::round((*z - *std::prev(z)) / kRiser_m);
    EXPECT_NEAR(*z - *std::prev(z), risers * kRiser_m, 0.01);
    if (risers > 1) ++double_risers;
  }
  EXPECT_LE(double_risers, 1) << "at the corner";
}

TEST(Stairs, LieOnTheGround) {
  const Built made = built(kUp, ramp_m);
  for (const auto& [a, b, c] : made.stairs.mesh.triangles) {
    const auto& positions = made.stairs.mesh.positions;
    const Vec3 p = (positions[a] + positions[b] + positions[c]) * (1.0 / 3);
    if (!tread_heights(made.stairs.mesh).contains(p.z)) continue;
    const double over_m = p.z - map::height_m_at(made.ground.terrain, in_plan(p));
    // by a riser, and the rise of the ground across the way
    EXPECT_GE(over_m, -0.07) << p.x;
    EXPECT_LE(over_m, made.stairs.error_m);
  }
  EXPECT_LE(made.stairs.error_m, kRiser_m + 2 * std::hypot(0.5, 0.25) + 0.1);
}

TEST(Stairs, AreTheSameFromBothEnds) {
  roads::Road down = kUp;
  std::ranges::reverse(down.axis);
  EXPECT_EQ(tread_heights(built(kUp, ramp_m).stairs.mesh).size(),
            tread_heights(built(down, ramp_m).stairs.mesh).size());
}

TEST(Stairs, GoUpAndDown) {
  const roads::Road over = steps_along({{-20, 0}, {20, 0}});
  const Mesh mesh = built(over, [](Vec2 p) { return 10 - std::abs(p.x) * 0.5; }).stairs.mesh;
  const std::set<double> heights = tread_heights(mesh);
  // each flight has risers of its own
  EXPECT_NEAR(static_cast<double>(heights.size()), 2 * 10 / kRiser_m, 4);
  EXPECT_LE(*heights.rbegin(), 10.01);
}

TEST(Stairs, HaveNoInvertedTreadsInSharpBends) {
  for (const Vec2 last : {Vec2{2, 1.5}, Vec2{2, 6}, Vec2{12, 12}, Vec2{0, -0.25}}) {
    const Built made = built(steps_along({{0, 0}, {10, 0}, last}), [](Vec2 p) { return 50 + 0.5 * p.x + 2 * p.y; });
    const Mesh& mesh = made.stairs.mesh;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
      const bool is_level = p.z == q.z && q.z == r.z;
      const Vec3 centre = (p + q + r) * (1.0 / 3);
      if (!is_level || cross(in_plan(q - p), in_plan(r - p)) <= 0) continue;
      EXPECT_GE(centre.z, map::height_m_at(made.ground.terrain, in_plan(centre)) - 0.25) << centre.x;
    }
  }
}

TEST(Stairs, AreNoneOnLevelGround) {
  EXPECT_TRUE(built(kUp, [](Vec2) { return 7.0; }).stairs.mesh.triangles.empty());
}

TEST(Stairs, KeepToTheirLandCoverAndTheBox) {
  const Built made = built(kUp, ramp_m, {{12, -64}, {64, 64}});
  ASSERT_FALSE(made.stairs.mesh.positions.empty());
  for (const Vec3 p : made.stairs.mesh.positions) EXPECT_LE(p.x, 12 + 0x1p-9);
}

TEST(Stairs, HaveTheTaggedNumberOfSteps) {
  roads::Road steps = steps_along({{0, 0}, {12, 0}});
  const auto ramp = [](Vec2 p) { return p.x / 6; };
  steps.riser_m = 0.25;
  const auto tagged = tread_heights(built(steps, ramp).stairs.mesh).size();
  steps.riser_m = 0;
  EXPECT_NEAR(static_cast<double>(tagged), 2 / 0.25, 1);
  EXPECT_GT(tread_heights(built(steps, ramp).stairs.mesh).size(), tagged);
}

TEST(Stairs, HandrailsStandAboveTheStepsOnTheirSide) {
  roads::Road steps = steps_along({{0, 0}, {12, 0}});
  const auto ramp = [](Vec2 p) { return p.x / 6; };
  EXPECT_TRUE(built(steps, ramp).stairs.rails.triangles.empty());
  steps.handrails = map::kHandrailLeft;
  const Stairs stairs = built(steps, ramp).stairs;
  ASSERT_FALSE(stairs.rails.triangles.empty());
  double highest_m = 0;
  for (const Vec3 p : stairs.rails.positions) {
    EXPECT_GT(p.y, 0.8);
    highest_m = std::max(highest_m, p.z);
  }
  EXPECT_NEAR(highest_m, 2 + kHandrail_m, 0.2);
  EXPECT_GE(stairs.error_m, kHandrail_m);
}

}  // namespace
}  // namespace citykiln::structures

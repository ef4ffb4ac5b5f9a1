#include "compiler/plants/expand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compiler/geometry/snap.h"
#include "compiler/plants/blue_noise.h"
#include "compiler/plants/plan.h"

namespace citykiln::plants {
namespace {

using ground::Surface;
using map::SurfaceClass;

map::Heightfield sloping(double grade) {
  map::Heightfield field{{-512, -512}, {16, 16}, 65, 65, {}, 0};
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 65; ++i)
      field.heights.push_back(static_cast<std::int32_t>(grade * (i * 16) / map::kHeightQuantum_m));
  return field;
}

Surface surface(std::int64_t id, SurfaceClass kind, Ring ring) {
  const auto area = static_cast<std::uint32_t>(signed_area_m2(ring));
  return {{{OsmType::kWay, id}, 0}, kind, area, {std::move(ring)}};
}

Ring block(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// A wood with a road through it, a lake and a house in it.
std::vector<Surface> wooded() {
  return {surface(1, SurfaceClass::kForest, block(-250, -230, 240, 250)),
          surface(2, SurfaceClass::kResidentialRoad, block(-300, -3, 300, 3)),
          surface(3, SurfaceClass::kLake, block(60, 40, 140, 110)),
          surface(4, SurfaceClass::kBuilding, block(-100, 50, -80, 70))};
}

const std::vector<Wood> kWoods = {{{{OsmType::kWay, 1}, 0}, 7.5, 0.4, 15}};
constexpr Box2 kAll = {{-256, -256}, {256, 256}};

Placed placed_in(const Box2& box, double grade, Report& report, std::span<const Tree> trees = {}) {
  const std::vector<Surface> surfaces = wooded();
  return expand(trees, kWoods, map_surfaces(surfaces, box.widened(kReach_m)), ground::Carving(sloping(grade)), box, 7,
                report);
}

std::vector<Placement> joined(const Placed& placed) {
  std::vector<Placement> all;
  for (const auto& [prototype, some] : placed) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end(), [](const Placement& a, const Placement& b) { return a.at < b.at; });
  return all;
}

TEST(Expand, KeepsTrunksApartOnTheGround) {
  for (const double grade : {0.0, 1.0}) {
    Report report;
    const auto trees = joined(placed_in(kAll, grade, report));
    double nearest = 1e9;
    for (std::size_t i = 0; i < trees.size(); ++i)
      for (std::size_t j = i + 1; j < trees.size() && trees[j].at.x < trees[i].at.x + 8; ++j)
        nearest = std::min(nearest, length(trees[j].at - trees[i].at));
    EXPECT_GE(nearest, 7.5 - 0.01);
    EXPECT_LT(nearest, 8);
  }
}

TEST(Expand, StandsDenserInPlanWhereTheGroundIsSteep) {
  Report report;
  const double flat = static_cast<double>(joined(placed_in(kAll, 0, report)).size());
  const double steep = static_cast<double>(joined(placed_in(kAll, 1, report)).size());
  EXPECT_NEAR(steep / flat, std::sqrt(2.0), 0.12);
}

TEST(Expand, FillsTheWood) {
  Report report;
  const auto trees = joined(placed_in(kAll, 0, report));
  const double wood_m2 = 490.0 * 480 - 490 * 8.5 - 82.5 * 72.5 - 22.5 * 22.5;
  // disks of the spacing cover a plane to 0.907 at most, by random dart throwing to 0.547, in circles of half the
  // spacing
  const double cover = static_cast<double>(trees.size()) * 3.14159 * 3.75 * 3.75 / wood_m2;
  EXPECT_GT(cover, 0.38);
  EXPECT_LT(cover, 0.6);
  std::size_t needles = 0;
  for (const auto& [prototype, placements] : placed_in(kAll, 0, report))
    if (prototype.species == Species::kSpruce) needles += placements.size();
  EXPECT_NEAR(static_cast<double>(needles) / static_cast<double>(trees.size()), 0.4, 0.05);
}

TEST(Expand, KeepsTrunksClearOfRoadsBuildingsAndWater) {
  Report report;
  const std::vector<Surface> surfaces = wooded();
  const auto map = map_surfaces(surfaces, kAll.widened(8));
  for (const Placement& tree : joined(placed_in(kAll, 0, report))) {
    EXPECT_EQ(surface_at(map, in_plan(tree.at)), 0u);
    EXPECT_GE(clearance_m(map, in_plan(tree.at), 50, 4), kTrunkClearance_m);
  }
}

TEST(Expand, PlantsTheSameTreesInHalvesAsInTheWhole) {
  Report report;
  const auto whole = joined(placed_in(kAll, 0.3, report));
  for (const double cut : {-128.0, 0.0, 37.0}) {
    auto halves = joined(placed_in({{-256, -256}, {cut, 256}}, 0.3, report));
    const auto east = joined(placed_in({{cut, -256}, {256, 256}}, 0.3, report));
    halves.insert(halves.end(), east.begin(), east.end());
    ASSERT_EQ(halves.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_EQ(halves[i].at, whole[i].at);
      EXPECT_EQ(halves[i].scale, whole[i].scale);
      EXPECT_EQ(halves[i].cos_yaw, whole[i].cos_yaw);
    }
  }
}

TEST(Expand, DependsOnNothingBeyondItsReach) {
  Report report;
  const Box2 box = {{-64, -64}, {64, 64}};
  std::vector<Surface> surfaces = wooded();
  const auto plant = [&] {
    return joined(expand({}, kWoods, map_surfaces(surfaces, box.widened(kReach_m)), ground::Carving(sloping(0.1)), box,
                         7, report));
  };
  const auto before = plant();
  // a clearing that begins just beyond
  surfaces.push_back(surface(5, SurfaceClass::kBuilding, block(128.5, -200, 230, 200)));
  const auto after = plant();
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].at, after[i].at);
}

TEST(Expand, CountsThePlacesThatStayUndecided) {
  Report report;
  const auto trees = joined(placed_in(kAll, 0, report));
  double undecided = 0;
  for (const Diagnosis& d : report.diagnoses())
    if (d.code == Code::kTreesUndecided) undecided += d.size;
  EXPECT_LT(undecided, 0.02 * static_cast<double>(trees.size()));
}

TEST(Expand, DropsSingleTreesOnRoadsBuildingsAndWaterAndBalances) {
  Report report;
  const auto tree = [](std::int64_t id, Vec2 at) { return Tree{{{OsmType::kNode, id}, 0}, at, 11, Species::kOak}; };
  const std::vector<Tree> trees = {tree(1, {0, 0}), tree(2, {100, 80}), tree(3, {-90, 60}), tree(4, {-290, 20}),
                                   tree(5, {10, 10})};
  const auto broad = joined(placed_in({{-256, -64}, {256, 256}}, 0, report, trees));
  EXPECT_EQ(
      std::count_if(broad.begin(), broad.end(), [](const Placement& p) { return p.feature.type == OsmType::kNode; }),
      1);
  EXPECT_EQ(report.counts()[Code::kTreeOnRoad], 3u);
  EXPECT_TRUE(report.balances());
}

TEST(Expand, StandsTreesOnTheGroundOnTheGrid) {
  Report report;
  const map::Heightfield heights = sloping(0.3);
  for (const Placement& tree : joined(placed_in(kAll, 0.3, report))) {
    EXPECT_EQ(tree.at, snapped(tree.at));
    EXPECT_NEAR(tree.at.z, height_m_at(heights, in_plan(tree.at)), 0.0005);
    EXPECT_NEAR(tree.cos_yaw * tree.cos_yaw + tree.sin_yaw * tree.sin_yaw, 1, 1e-12);
    EXPECT_LE(tree.scale, kTallestTree_m);
  }
}

TEST(Plan, KeepsEveryTreeAndFindsTheWoods) {
  map::Features features;
  features.points = {{{{OsmType::kNode, 1}, 0}, {1, 2}, map::PointKind::kTree, 0, {map::PlantKind::kUntold, map::LeafType::kNeedle}},
                     {{{OsmType::kNode, 2}, 0}, {3, 4}, map::PointKind::kBench}};
  Report report;
  const Plants plants = plan(features, wooded(), report);
  ASSERT_EQ(plants.trees.size(), 1u);
  EXPECT_EQ(plants.trees[0].species, Species::kSpruce);
  ASSERT_EQ(plants.woods.size(), 1u);
  EXPECT_EQ(plants.woods[0].surface, (ObjectId{{OsmType::kWay, 1}, 0}));
  EXPECT_EQ(report.ledger().at("plants/tree").out, 1u);
  EXPECT_TRUE(report.balances());
}

}  // namespace
}  // namespace citykiln::plants

#include "compiler/props/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/props/drape_line.h"
#include "compiler/props/plan.h"

namespace citykiln::props {
namespace {

// Hills with a different slope on every face.
map::Heightfield hills() {
  map::Heightfield field{{-64, -64}, {16, 16}, 9, 9, {}, 0};
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) field.heights.push_back((i * i * 37 + j * 211 + i * j * 53) % 900);
  return field;
}

// Ungraded terrain.
ground::GradedTerrain hilly() { return ground::GradedTerrain(hills()); }

Barrier wall(Polyline axis) { return {{{OsmType::kWay, 3}, 0}, std::move(axis), map::BarrierKind::kWall, 2, 0.5}; }

std::map<std::pair<Vec3, Vec3>, int> open_edges(const Mesh& mesh) {
  std::map<std::pair<Vec3, Vec3>, int> edges;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = mesh.positions[t[i]], b = mesh.positions[t[(i + 1) % 3]];
      if (a < b)
        ++edges[{a, b}];
      else
        --edges[{b, a}];
    }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

TEST(DrapeLine, LiesOnTheGround) {
  const map::Heightfield field = hills();
  const Polyline line = {{-60.5, -50}, {33.25, 41}, {50, -62}, {-64, -64}, {16, 16}, {16, 60}, {90, 70}};
  const std::vector<Vec3> points = drape_line(line, hilly());
  ASSERT_GT(points.size(), line.size());
  for (std::size_t i = 1; i < points.size(); ++i)
    for (int k = 0; k <= 8; ++k) {
      const Vec3 p = points[i - 1] + (points[i] - points[i - 1]) * (k / 8.0);
      if (!field.box().contains(in_plan(p))) continue;
      EXPECT_NEAR(p.z, height_m_at(field, in_plan(p)), 0.004);
    }
}

TEST(DrapeLine, KeepsAllPointsWithoutRepeats) {
  const Polyline line = {{-60.5, -50}, {33.25, 41}, {33.25, 41}, {48, 48}};
  const std::vector<Vec3> points = drape_line(line, hilly());
  EXPECT_EQ(in_plan(points.front()), line.front());
  EXPECT_EQ(in_plan(points.back()), line.back());
  for (const Vec2 p : line)
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](Vec3 q) { return in_plan(q) == p; }));
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_NE(in_plan(points[i - 1]), in_plan(points[i]));
}

TEST(DrapeLine, LeavesOutSmallBendsOnly) {
  const std::vector<Vec3> points = drape_line({{-60.5, -50}, {33.25, 41}, {50, -62}, {-64, -64}}, hilly());
  const std::vector<Vec3> fewer = without_small_bends(points, 0.05);
  EXPECT_LT(fewer.size(), points.size());
  EXPECT_EQ(without_small_bends({{0, 0, 0}, {1, 0, 0.01}, {2, 0, 0}, {3, 1, 0}}, 0.05).size(), 3u);
  EXPECT_EQ(fewer.front(), points.front());
  EXPECT_EQ(fewer.back(), points.back());
  for (const Vec3 p : points) {
    double off_m = 1e9;
    for (std::size_t i = 1; i < fewer.size(); ++i)
      off_m = std::min(off_m, distance_to_segment(fewer[i - 1], fewer[i], p));
    EXPECT_LE(off_m, 0.05);
  }
}

TEST(Generate, IsOpenOnlyUnderTheGround) {
  const map::Heightfield field = hills();
  for (const Polyline& axis :
       {Polyline{{-60, -50}, {20, 30}, {50, 31}}, Polyline{{-30, -30}, {30, -30}, {30, 30}, {-30, -30}}}) {
    const GeneratedProp e = generate(wall(axis), hilly(), 0.02);
    ASSERT_EQ(e.meshes.size(), 2u);
    ASSERT_FALSE(e.meshes[0].mesh.triangles.empty());
    EXPECT_TRUE(open_edges(e.meshes[1].mesh).empty());
    for (const auto& [edge, count] : open_edges(e.meshes[0].mesh))
      for (const Vec3 p : {edge.first, edge.second}) EXPECT_LT(p.z, height_m_at(field, in_plan(p)));
  }
}

TEST(Generate, HasTheRecipesWidthAndHeight) {
  map::Heightfield flat = hills();
  std::fill(flat.heights.begin(), flat.heights.end(), 640);
  const Mesh mesh = generate(wall({{0, 3}, {40, 3}}), ground::GradedTerrain(std::move(flat)), 0.1).meshes[0].mesh;
  for (const Vec3 p : mesh.positions) {
    EXPECT_TRUE(p.y == 2.75 || p.y == 3.25);
    EXPECT_TRUE(p.z == 12 || p.z < 10);
    EXPECT_EQ(p, snapped(p));
  }
  // all faces point outwards
  double six = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    six += dot(mesh.positions[a] - Vec3{20, 3, 9.5},
               cross(mesh.positions[b] - Vec3{20, 3, 9.5}, mesh.positions[c] - Vec3{20, 3, 9.5}));
  EXPECT_NEAR(six / 6, 40 * 0.5 * 2.5, 40 * 0.5 * 0.01);
}

TEST(Generate, LowWallsEndInPiers) {
  map::Heightfield flat = hills();
  std::fill(flat.heights.begin(), flat.heights.end(), 640);
  const ground::GradedTerrain ground(std::move(flat));
  Barrier low = wall({{0, 3}, {40, 3}});
  low.height_m = 1;
  double top = 0;
  const GeneratedProp fine = generate(low, ground, 0.1);
  for (const Vec3 p : fine.meshes[0].mesh.positions) top = std::max(top, p.z);
  EXPECT_NEAR(top, 11.15, 0.01);
  const GeneratedProp coarse = generate(low, ground, 0.5);
  for (const Vec3 p : coarse.meshes[0].mesh.positions) EXPECT_LT(p.z, 11.01);
  EXPECT_GE(coarse.error_m, 0.15);
  EXPECT_LE(coarse.error_m, 0.5);
}

TEST(Generate, WallsEndInACopingWhereTheToleranceShowsIt) {
  map::Heightfield flat = hills();
  std::fill(flat.heights.begin(), flat.heights.end(), 640);
  const ground::GradedTerrain ground(std::move(flat));
  const GeneratedProp fine = generate(wall({{0, 3}, {40, 3}}), ground, 0.05);
  ASSERT_EQ(fine.meshes.size(), 2u);
  EXPECT_NEAR(fine.error_m, 0.0125, 1e-9);
  for (const Vec3 p : fine.meshes[0].mesh.positions) EXPECT_LT(p.z, 12);
  Box2 plan;
  for (const Vec3 p : fine.meshes[1].mesh.positions) {
    EXPECT_TRUE(p.z == 12 || p.z < 12 - 0.07);
    plan.grow(in_plan(p));
  }
  EXPECT_NEAR(plan.max.y - plan.min.y, 0.5 + 0.12, 0.005);
  const GeneratedProp coarse = generate(wall({{0, 3}, {40, 3}}), ground, 0.1);
  EXPECT_EQ(coarse.meshes.size(), 1u);
  EXPECT_NEAR(coarse.error_m, 0.085, 1e-9);
}

TEST(Generate, DropsWhatIsLowerThanTheToleranceAndIsTotal) {
  const GeneratedProp dropped = generate(wall({{0, 0}, {9, 0}}), hilly(), 2.5);
  EXPECT_TRUE(dropped.meshes.empty());
  EXPECT_EQ(dropped.error_m, 2);
  EXPECT_TRUE(generate(wall({}), hilly(), 0.1).meshes.empty());
  EXPECT_TRUE(generate(wall({{1, 1}, {1, 1}}), hilly(), 0.1).meshes.empty());
  EXPECT_FALSE(generate(wall({{0, 0}, {9, 0}, {0, 0}}), hilly(), 0.1).meshes.empty());
}

TEST(Place, PutsLampsOnTheGroundAndTurnsThem) {
  const StreetLamp lamp{{5, 7}, {0.6, -0.8}, 6, LampKind::kArm, {OsmType::kNode, 8}};
  const Placement p = place(lamp, hilly());
  EXPECT_NEAR(p.at.z, height_m_at(hills(), {5, 7}), 0.0005);
  EXPECT_EQ(p.scale, 6);
  EXPECT_EQ(p.cos_yaw, 0.6);
  EXPECT_EQ(p.sin_yaw, -0.8);
  EXPECT_EQ(p.feature, lamp.feature);
}

TEST(Plan, MakesLampsAndBarriersAndCountsTheRest) {
  map::Features f;
  f.extent = {{0, 0}, {128, 128}};
  f.barriers = {{{{OsmType::kWay, 9}, 0}, {{0, 0}, {1, 1}}, map::BarrierKind::kHedge, 1.5, 0.75},
                {{{OsmType::kWay, 2}, 0}, {{0, 0}, {1, 1}}, map::BarrierKind::kWall, 1.5, 0.75}};
  f.points = {{{{OsmType::kNode, 1}, 0}, {1, 2}, map::PointKind::kTree},
              {{{OsmType::kNode, 3}, 0}, {5, 4}, map::PointKind::kStreetLamp},
              {{{OsmType::kNode, 4}, 0}, {6, 4}, map::PointKind::kStreetLamp, 9},
              {{{OsmType::kNode, 5}, 0}, {7, 4}, map::PointKind::kShop}};
  Report report;
  const Props props = plan(f, {}, report);
  ASSERT_EQ(props.barriers.size(), 2u);
  EXPECT_LT(props.barriers[0].id, props.barriers[1].id);
  ASSERT_EQ(props.lamps.size(), 2u);
  EXPECT_EQ(props.lamps[0].height_m, 0);
  EXPECT_EQ(props.lamps[1].height_m, 9);
  EXPECT_EQ(report.ledger().at("props/point").in, 3u);
  EXPECT_EQ(report.ledger().at("props/point").without_body, 1u);
  EXPECT_TRUE(report.balances());
}

TEST(Plan, BarriersEndALittleOutsideOfTheRegion) {
  map::Features f;
  f.extent = {{0, 0}, {128, 128}};
  f.barriers = {
      {{{OsmType::kWay, 9}, 0}, {{-50, 10}, {500, 10}, {500, 20}, {-50, 20}}, map::BarrierKind::kWall, 1.5, 0.75},
      {{{OsmType::kWay, 10}, 0}, {{-50, 0}, {-50, 90}}, map::BarrierKind::kWall, 1.5, 0.75}};
  Report report;
  const Props props = plan(f, {}, report);
  ASSERT_EQ(props.barriers.size(), 2u);
  EXPECT_EQ(props.barriers[0].axis, (Polyline{{-4, 10}, {132, 10}}));
  EXPECT_EQ(props.barriers[1].axis, (Polyline{{132, 20}, {-4, 20}}));
  EXPECT_EQ(props.barriers[1].id.part, 1u);
  EXPECT_EQ(report.ledger().at("props/barrier").dropped.at(Code::kOutsideBounds), 1u);
  EXPECT_TRUE(report.balances());
}

}  // namespace
}  // namespace citykiln::props

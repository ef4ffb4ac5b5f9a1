#include "compiler/surroundings/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compiler/surroundings/curvature.h"
#include "compiler/surroundings/grid_lines.h"

namespace citykiln::surroundings {
namespace {

using materials::Material;
using materials::MaterialMesh;

const Box2 kRegion{{-256, -128}, {256, 128}};

double terrain_m(Vec2 p) { return 600 + 0.06 * p.x - 0.05 * p.y + 8 * std::sin(p.x / 50); }

Surroundings hills(bool has_sea = false) {
  Surroundings around{.x_m = lines_for(kRegion.min.x, kRegion.max.x, 256),
                      .y_m = lines_for(kRegion.min.y, kRegion.max.y, 256),
                      .heights_m = {},
                      .covers = {}};
  for (std::size_t j = 0; j < around.rows(); ++j)
    for (std::size_t i = 0; i < around.columns(); ++i) {
      const bool is_sea = has_sea && around.y_m[j] < -1000;
      around.heights_m.push_back(is_sea ? 0
                                        : static_cast<std::int32_t>(std::floor(terrain_m(around.vertex(i, j)) + 0.5)));
      around.covers.push_back(is_sea ? Cover::kSea : Cover::kLand);
    }
  return around;
}

Neighbourhood neighbourhood(const Box2& tiles = kRegion) {
  return {.extent = kRegion,
          .is_in_tile = [tiles](Vec2 p) { return tiles.contains(p); },
          .on_border =
              [](Vec2 p) {
                return BorderGround{terrain_m(p), false};
              },
          .land_at =
              [](Vec3, Vec3) {
                return materials::SurfaceMaterial{Material::kScree, {90, 100, 60, 255}};
              }};
}

// Area in plan, skirts have none; each directed edge counts.
struct Measured {
  double area_m2 = 0, lowest_normal_z = 1;
  std::map<std::pair<std::array<double, 3>, std::array<double, 3>>, int> edges;
};

Measured measure(const std::vector<MaterialMesh>& meshes) {
  Measured measured;
  for (const MaterialMesh& part : meshes)
    for (const Triangle& t : part.mesh.triangles) {
      Vec3 at[3];
      for (int k = 0; k < 3; ++k) at[k] = part.mesh.positions[t[static_cast<std::size_t>(k)]];
      const double area = twice_area(in_plan(at[0]), in_plan(at[1]), in_plan(at[2])) / 2;
      if (area == 0) continue;
      measured.area_m2 += area;
      measured.lowest_normal_z = std::min(measured.lowest_normal_z, area > 0 ? 1.0 : -1.0);
      for (int k = 0; k < 3; ++k) {
        const Vec3 a = at[k], b = at[(k + 1) % 3];
        ++measured.edges[{{a.x, a.y, a.z}, {b.x, b.y, b.z}}];
      }
    }
  return measured;
}

double area_of(const Box2& box) { return box.width() * box.height(); }

TEST(GenerateSurroundings, CoversAllBesideTheTilesOnce) {
  const Surroundings around = hills();
  const Box2 one_tile{{0, -128}, {256, 128}};
  for (const Box2& tiles : {kRegion, one_tile}) {
    const Measured measured = measure(generate(around, neighbourhood(tiles)));
    EXPECT_NEAR(measured.area_m2, area_of(around.box()) - area_of(tiles), 1);
    EXPECT_EQ(measured.lowest_normal_z, 1);
  }
}

TEST(GenerateSurroundings, HasNoGapBetweenCells) {
  const Surroundings around = hills(true);
  const Measured measured = measure(generate(around, neighbourhood()));
  const Box2 box = around.box();
  int open = 0;
  for (const auto& [edge, count] : measured.edges) {
    EXPECT_EQ(count, 1);
    if (measured.edges.contains({edge.second, edge.first})) continue;
    ++open;
    const auto [a, b] = edge;
    const bool is_outer = (a[0] == b[0] && (a[0] == box.min.x || a[0] == box.max.x)) ||
                          (a[1] == b[1] && (a[1] == box.min.y || a[1] == box.max.y));
    const Vec2 middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    EXPECT_TRUE(is_outer || away_m(kRegion, middle) == 0) << middle.x << " " << middle.y;
  }
  EXPECT_GT(open, 100);
}

TEST(GenerateSurroundings, OnTheBorderOfTilesItHasTheHeightsOfTheirGround) {
  std::set<std::pair<double, double>> seen;
  for (const MaterialMesh& part : generate(hills(), neighbourhood())) {
    double lowest_m = 1e9;
    for (const Vec3 p : part.mesh.positions) lowest_m = std::min(lowest_m, p.z);
    for (const Vec3 p : part.mesh.positions) {
      if (away_m(kRegion, in_plan(p)) > 0) continue;
      const double above_m = p.z - terrain_m(in_plan(p));
      // itself, or the lower end of the skirt
      EXPECT_NEAR(above_m < -1 ? above_m + kSkirt_m : above_m, 0, 0.01) << p.x << " " << p.y;
      seen.insert({p.x, p.y});
    }
  }
  // 1,536 m of border
  EXPECT_GE(seen.size(), 1536 / kBorderStep_m);
}

TEST(GenerateSurroundings, FollowsTheEarthsCurveUnlessItIsBentLater) {
  const Surroundings around = hills();
  Neighbourhood curved = neighbourhood(), flat = neighbourhood();
  flat.is_curved = false;
  const auto low = generate(around, curved), high = generate(around, flat);
  ASSERT_EQ(low.size(), 1u);
  ASSERT_EQ(low[0].mesh.positions.size(), high[0].mesh.positions.size());
  double most_m = 0;
  for (std::size_t i = 0; i < low[0].mesh.positions.size(); ++i) {
    const Vec3 a = low[0].mesh.positions[i], b = high[0].mesh.positions[i];
    const double drop = drop_m(away_m(kRegion, in_plan(a)));
    EXPECT_NEAR(b.z - a.z, drop, 0.02);
    most_m = std::max(most_m, drop);
  }
  EXPECT_GT(most_m, 240);
}

TEST(GenerateSurroundings, SeaIsSeaAndLevelButForTheCurve) {
  const auto meshes = generate(hills(true), neighbourhood());
  ASSERT_EQ(meshes.size(), 2u);
  const auto sea = std::ranges::find(meshes, Material::kSea, &MaterialMesh::material);
  ASSERT_NE(sea, meshes.end());
  EXPECT_GT(sea->mesh.triangles.size(), 100u);
  for (const Vec3 p : sea->mesh.positions) EXPECT_NEAR(p.z, -drop_m(away_m(kRegion, in_plan(p))), 0.01);
}

}  // namespace
}  // namespace citykiln::surroundings

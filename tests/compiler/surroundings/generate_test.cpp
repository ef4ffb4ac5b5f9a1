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

double distance_of(const Box2& a, const Box2& b) {
  return length(Vec2{std::max({a.min.x - b.max.x, b.min.x - a.max.x, 0.0}),
                     std::max({a.min.y - b.max.y, b.min.y - a.max.y, 0.0})});
}

// Meadow, with woods in the west if they are wanted.
Neighbourhood neighbourhood(const Box2& tiles = kRegion, bool has_woods = false) {
  return {.extent = kRegion,
          .away_m = [tiles](const Box2& box) { return distance_of(tiles, box); },
          .is_in_tile = [tiles](Vec2 p) { return tiles.contains(p); },
          .on_border =
              [](Vec2 p) {
                return BorderGround{terrain_m(p), Cover::kLand};
              },
          .height_m_at = terrain_m,
          .patch_of =
              [has_woods](const Cell& cell) {
                const bool is_wood = has_woods && cell.x_m < -100 && cell.side_m <= 64;
                return Patch{.cover = map::LandCoverClass::kMeadow, .raised_m = is_wood ? 10.0 : 0.0};
              },
          .material_at = [](const Patch& patch, Vec3,
                            Vec3) { return patch.raised_m > 0 ? Material::kForestFloor : Material::kScree; },
          .tint_at =
              [](const Patch&, Material, Vec3, Vec3) {
                return materials::Tint{90, 100, 60, 255};
              }};
}

std::vector<MaterialMesh> meshes_of(const Surroundings& around, const Neighbourhood& beside) {
  return AroundSurface(around, beside).meshes();
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
    const Measured measured = measure(meshes_of(around, neighbourhood(tiles)));
    // whole squares of the largest side, but for the moved vertices of the outer border
    EXPECT_GT(measured.area_m2, area_of(around.box()) - area_of(tiles));
    EXPECT_LT(measured.area_m2, area_of(around.box().widened(1.5 * kLargestCell_m)) - area_of(tiles));
    EXPECT_EQ(measured.lowest_normal_z, 1);
  }
}

TEST(GenerateSurroundings, HasNoGapBetweenCells) {
  const Surroundings around = hills(true);
  const Measured measured = measure(meshes_of(around, neighbourhood()));
  const Box2 box = around.box();
  int open = 0;
  for (const auto& [edge, count] : measured.edges) {
    EXPECT_EQ(count, 1);
    if (measured.edges.contains({edge.second, edge.first})) continue;
    ++open;
    const auto [a, b] = edge;
    const Vec2 middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    EXPECT_TRUE(!box.contains(middle) || away_m(kRegion, middle) == 0) << middle.x << " " << middle.y;
  }
  EXPECT_GT(open, 60);
}

TEST(GenerateSurroundings, OnTheBorderOfTilesItHasTheHeightsOfTheirGround) {
  std::set<std::pair<double, double>> seen;
  for (const MaterialMesh& part : meshes_of(hills(), neighbourhood())) {
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

TEST(GenerateSurroundings, WoodsRiseFromTheGroundAtTheirEdges) {
  const auto meshes = meshes_of(hills(), neighbourhood(kRegion, true));
  const auto wood = std::ranges::find(meshes, Material::kForestFloor, &MaterialMesh::material);
  ASSERT_NE(wood, meshes.end());
  double highest_m = 0, steepest = 1;
  for (const Vec3 p : wood->mesh.positions) highest_m = std::max(highest_m, p.z - terrain_m(in_plan(p)));
  EXPECT_GT(highest_m, 10);
  EXPECT_LT(highest_m, 16);
  // no vertical sides
  for (const Vec3 normal : wood->mesh.normals) steepest = std::min(steepest, normal.z);
  EXPECT_GT(steepest, 0.5);
  const Measured measured = measure(meshes);
  int open = 0;
  for (const auto& [edge, count] : measured.edges) {
    const Vec2 middle{(edge.first[0] + edge.second[0]) / 2, (edge.first[1] + edge.second[1]) / 2};
    open += !measured.edges.contains({edge.second, edge.first}) && away_m(kRegion, middle) > 0 &&
            away_m(kRegion, middle) < 1000;
  }
  EXPECT_EQ(open, 0);
}

// Red in the west and green in the east.
TEST(GenerateSurroundings, TintsOfCellsMeetInTheirMean) {
  Neighbourhood beside = neighbourhood();
  beside.patch_of = [](const Cell& cell) {
    return Patch{.cover = map::LandCoverClass::kMeadow, .tint = {cell.x_m < 0 ? 1.0 : 0.0, 0, 0}};
  };
  beside.tint_at = [](const Patch& patch, Material, Vec3, Vec3) {
    return patch.tint[0] > 0 ? materials::Tint{200, 0, 0, 255} : materials::Tint{0, 200, 0, 255};
  };
  const auto meshes = meshes_of(hills(), beside);
  ASSERT_EQ(meshes.size(), 1u);
  std::set<std::array<double, 3>> places;
  int mixed = 0;
  for (std::size_t i = 0; i < meshes[0].mesh.positions.size(); ++i) {
    const Vec3 p = meshes[0].mesh.positions[i];
    const materials::Tint tint = meshes[0].tints[i];
    EXPECT_TRUE(places.insert({p.x, p.y, p.z}).second);
    EXPECT_EQ(tint[0] + tint[1], 200);
    mixed += tint[0] > 0 && tint[1] > 0;
  }
  EXPECT_GT(mixed, 50);
}

TEST(GenerateSurroundings, OnTheBorderOfTilesItHasTheTintOfTheirGround) {
  Neighbourhood beside = neighbourhood();
  beside.patch_on_border = [](Vec2) { return Patch{.cover = map::LandCoverClass::kMeadow, .tint = {0.5, 0, 0}}; };
  beside.tint_at = [](const Patch& patch, Material, Vec3, Vec3) {
    return materials::Tint{static_cast<std::uint8_t>(patch.tint[0] * 200), 0, 0, 255};
  };
  for (const MaterialMesh& mesh : meshes_of(hills(), beside))
    for (std::size_t i = 0; i < mesh.mesh.positions.size(); ++i)
      EXPECT_EQ(mesh.tints[i][0], away_m(kRegion, in_plan(mesh.mesh.positions[i])) == 0 ? 100 : 200);
}

TEST(GenerateSurroundings, KnowsTheHeightOfItsGround) {
  const Surroundings around = hills();
  const Neighbourhood beside = neighbourhood(kRegion, true);
  const AroundSurface surface(around, beside);
  for (const Vec2 p : {Vec2{300, 10}, Vec2{-290.5, 77}, Vec2{10, 200.25}, Vec2{4000, 4100}}) {
    const auto height_m = surface.height_m_at(p);
    ASSERT_TRUE(height_m) << p.x;
    EXPECT_NEAR(*height_m, terrain_m(p) - drop_m(away_m(kRegion, p)), distance(p, {}) < 1000 ? 2.5 : 20) << p.x;
  }
  EXPECT_FALSE(surface.height_m_at({0, 0}));
  EXPECT_FALSE(surface.height_m_at({200000, 0}));
}

TEST(GenerateSurroundings, FollowsTheEarthsCurveUnlessItIsBentLater) {
  const Surroundings around = hills();
  Neighbourhood curved = neighbourhood(), flat = neighbourhood();
  flat.is_curved = false;
  const auto low = meshes_of(around, curved), high = meshes_of(around, flat);
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
  const auto meshes = meshes_of(hills(true), neighbourhood());
  ASSERT_EQ(meshes.size(), 2u);
  const auto sea = std::ranges::find(meshes, Material::kSea, &MaterialMesh::material);
  ASSERT_NE(sea, meshes.end());
  EXPECT_GT(sea->mesh.triangles.size(), 100u);
  EXPECT_LT(sea->mesh.triangles.size(), 0.6 * meshes[meshes[0].material == Material::kSea].mesh.triangles.size());
  for (const Vec3 p : sea->mesh.positions) EXPECT_NEAR(p.z, -drop_m(away_m(kRegion, in_plan(p))), 0.01);
}

}  // namespace
}  // namespace citykiln::surroundings

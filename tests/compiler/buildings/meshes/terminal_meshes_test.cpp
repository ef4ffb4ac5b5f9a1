#include "compiler/buildings/meshes/terminal_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "compiler/materials/texture.h"
#include "grammars/language/read_rules.h"
#include "tests/compiler/mesh_volume.h"

namespace citykiln::buildings {
namespace {

using materials::Material;
using materials::MaterialMesh;
using materials::SurfaceMaterial;

grammars::Derivation derived(const std::string& text) {
  const auto program = grammars::read_rules_of(text);
  EXPECT_TRUE(program) << to_string(program.error());
  const Polygon footprint{{{0, 0}, {12, 0}, {12, 5}, {5, 5}, {5, 9}, {0, 9}}, {{{1, 1}, {1, 4}, {4, 4}, {4, 1}}}};
  return derive(*program, grammars::lot(footprint, 2, 0, StableId{1}, {0}), {});
}

double area_m2_of(const MaterialMesh& part) {
  double sum_m2 = 0;
  const auto& p = part.mesh.positions;
  for (const auto& [a, b, c] : part.mesh.triangles) sum_m2 += length(cross(p[b] - p[a], p[c] - p[a])) / 2;
  return sum_m2;
}

grammars::Appearance look_of(const char* name, double red, double green, double blue) {
  grammars::Appearance look;
  look.name = name, look.red = red, look.green = green, look.blue = blue;
  return look;
}

constexpr const char* kBlock = R"(
Lot --> extrude(6) comp(f) { side : Wall | top : Roof. | bottom : set(material.name, "concrete") Floor. }
Wall --> set(material.name, "brick") split(x) { { ~2 : Tile }* }
Tile --> setback(0.4) { all : Frame. | remainder : set(material.name, "glass") color("#3c4a55") Pane. }
)";

TEST(TerminalMeshes, AreClosedForAClosedShape) {
  const auto meshes = terminal_meshes(derived(kBlock), {OsmType::kWay, 7}, 0);
  EXPECT_NEAR(volume_m3(meshes), (12 * 5 + 5 * 4 - 9) * 6, 1e-9);
  for (const MaterialMesh& part : meshes) EXPECT_EQ(part.feature, (OsmId{OsmType::kWay, 7}));
}

TEST(TerminalMeshes, AreOnePerMaterialAndTint) {
  const auto meshes = terminal_meshes(derived(kBlock), {}, 0);
  ASSERT_EQ(meshes.size(), 4u);
  for (std::size_t i = 1; i < meshes.size(); ++i)
    EXPECT_LT((SurfaceMaterial{meshes[i - 1].material, meshes[i - 1].tint}),
              (SurfaceMaterial{meshes[i].material, meshes[i].tint}));
  EXPECT_EQ(meshes[0].material, Material::kConcrete);
  EXPECT_NEAR(area_m2_of(meshes[0]), 12 * 5 + 5 * 4 - 9, 1e-9);
  EXPECT_EQ(meshes[3].material, Material::kGlass);
}

TEST(TerminalMeshes, UseTheFacesOwnPoints) {
  const auto derivation = derived(kBlock);
  std::set<Vec3> own;
  for (const auto& terminal : derivation.terminals)
    for (const auto& face : terminal.faces) each_vertex(face, [&](Vec3 p) { own.insert(p); });
  const std::vector<MaterialMesh> meshes = terminal_meshes(derivation, {}, 0);
  ASSERT_FALSE(meshes.empty());
  for (const MaterialMesh& part : meshes)
    for (const Vec3 p : part.mesh.positions) EXPECT_TRUE(own.contains(p));
}

// A wall under a ridge, an arrow, an L, a T and a spiral, starting at each of their corners.
TEST(AddFace, FillsEveryRingWithItsTrianglesOnce) {
  const std::vector<Ring> rings = {{{0, 0}, {6, 0}, {6, 3}, {3, 3}, {0, 3}},
                                   {{0, 0}, {4, -2}, {2, 0}, {4, 2}},
                                   {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}},
                                   {{2, 0}, {4, 0}, {4, 3}, {6, 3}, {6, 5}, {0, 5}, {0, 3}, {2, 3}},
                                   {{0, 0},
                                    {9, 0},
                                    {9, 8},
                                    {2, 8},
                                    {2, 2},
                                    {6, 2},
                                    {6, 5},
                                    {4, 5},
                                    {4, 4},
                                    {5, 4},
                                    {5, 3},
                                    {3, 3},
                                    {3, 7},
                                    {8, 7},
                                    {8, 1},
                                    {0, 1}}};
  for (Ring ring : rings)
    for (std::size_t turn = 0; turn < ring.size(); ++turn) {
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      grammars::Face face;
      for (const Vec2 p : ring) face.outer.push_back({p.x, 0.6 * p.y, 0.8 * p.y});
      Mesh mesh;
      add_face(face, mesh);
      EXPECT_EQ(mesh.triangles.size(), ring.size() - 2);
      double sum_m2 = 0;
      for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        const double area = dot(cross(p[b] - p[a], p[c] - p[a]), normal_of(face)) / 2;
        EXPECT_GT(area, 1e-6);
        sum_m2 += area;
      }
      EXPECT_NEAR(sum_m2, signed_area_m2(ring), 1e-9);
    }
}

TEST(TerminalMeshes, HaveTextureCoordinatesInMetres) {
  int textured = 0;
  for (const MaterialMesh& part : terminal_meshes(derived(kBlock), {}, 0)) {
    const bool has_texture = materials::has_texture(part.material, 0);
    EXPECT_EQ(part.uvs.size(), has_texture ? part.mesh.positions.size() : 0u);
    if (!has_texture) continue;
    ++textured;
    for (const Triangle& t : part.mesh.triangles) {
      const auto& p = part.mesh.positions;
      EXPECT_NEAR(distance(part.uvs[t[0]], part.uvs[t[1]]), length(p[t[0]] - p[t[1]]), 0.006);
      // v gives the height on a wall
      if (part.material == Material::kBrick) {
        EXPECT_NEAR(part.uvs[t[0]].y, p[t[0]].z, 0.002);
      }
    }
    for (const Vec2 uv : part.uvs)
      for (const double m : {uv.x, uv.y})
        EXPECT_EQ(m / materials::kTextureCoordinateStep_m, std::floor(m / materials::kTextureCoordinateStep_m));
  }
  EXPECT_GE(textured, 2);
}

TEST(TerminalMeshes, LeaveTextureCoordinatesOffSmallFacesOnCoarserLevels) {
  for (const double tolerance_m : {0.02, 0.1, 0.5})
    for (const MaterialMesh& part : terminal_meshes(derived(kBlock), {}, tolerance_m)) {
      const bool is_shown = materials::has_texture(part.material, tolerance_m);
      if (!is_shown || tolerance_m < 0.06) {
        EXPECT_EQ(part.uvs.size(), is_shown ? part.mesh.positions.size() : 0u);
      }
    }
}

TEST(TerminalMeshes, AreTotalForDegenerateFaces) {
  grammars::Derivation derivation;
  derivation.appearances.emplace_back();
  auto& faces = derivation.terminals.emplace_back().faces;
  faces.resize(3);
  faces[1].outer = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  faces[2].outer = {{0, 0, 0}, {1, 0, 1}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_LE(terminal_meshes(derivation, {}, 0).size(), 1u);
  derivation.appearances[0].name = "stone";
  EXPECT_LE(terminal_meshes(derivation, {}, 0).size(), 1u);
}

TEST(SurfaceMaterialOf, FindsEveryMaterialByItsName) {
  for (const char* name : {"plaster", "brick", "stone", "timber", "concrete", "glass_facade", "metal_cladding",
                           "roof_tile", "slate", "flat_roof", "metal_roof", "painted_metal", "paint", "glass"})
    EXPECT_TRUE(materials::material_named(name)) << name;
  EXPECT_EQ(surface_material_of(look_of("metal_roof", 1, 1, 1)).material, Material::kMetalRoof);
  EXPECT_EQ(surface_material_of(look_of("nonsense", 1, 1, 1)).material, Material::kPlaster);
  for (const char* name : {"", "Roof_tile", "roof_til", "roof_tiles", "rooftile", "_roof_tile", "roof__tile"})
    EXPECT_FALSE(materials::material_named(name)) << name;
}

TEST(SurfaceMaterialOf, IsALightVariantForColoursLighterThanTheMaterial) {
  EXPECT_EQ(surface_material_of(look_of("brick", 0.35, 0.2, 0.15)).material, Material::kBrick);
  EXPECT_EQ(surface_material_of(look_of("brick", 0.95, 0.9, 0.85)).material, Material::kLightBrick);
  EXPECT_EQ(surface_material_of(look_of("plaster", 0.4, 0.3, 0.2)).material, Material::kLightPlaster);
  EXPECT_EQ(surface_material_of(look_of("roof_tile", 0.95, 0.9, 0.85)).material, Material::kPaint);
  EXPECT_EQ(surface_material_of(look_of("glass", 0.95, 0.9, 0.85)).material, Material::kGlass);
}

TEST(SurfaceMaterialOf, HasNoTintForTheDefaultColour) {
  EXPECT_EQ(surface_material_of(look_of("brick", 1, 1, 1)), (SurfaceMaterial{Material::kBrick, materials::kNoTint}));
}

}  // namespace
}  // namespace citykiln::buildings

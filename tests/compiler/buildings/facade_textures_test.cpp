#include "compiler/buildings/facade_textures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/buildings/generate.h"
#include "compiler/buildings/styles/style.h"
#include "compiler/contract/detail_tolerances.h"

namespace citykiln::buildings {
namespace {

using materials::Material;
using materials::MaterialMesh;

Building building_of_style(Style style, double width_m, double height_m) {
  Building b;
  b.id = {{OsmType::kWay, 7}, 0};
  b.footprint = {{{0, 0}, {width_m, 0}, {width_m, 14}, {0, 14}}, {}};
  b.top_m = height_m;
  b.levels = static_cast<std::uint8_t>(height_m / 3);
  b.wall = Material::kPlaster, b.roof = Material::kFlatRoof;
  b.style = style;
  return b;
}

const Rulebook& rulebook() {
  static const Rulebook book = parse_rulebook(shipped_rules());
  return book;
}

GeneratedBuilding expanded(const Building& building, double tolerance_m) {
  Report report;
  return generate(building, rulebook(), {1}, tolerance_m, report);
}

// Areas, and the mean colour of vertical faces by area.
struct Shown {
  double area_m2 = 0, wall_m2 = 0;
  std::array<double, 3> light{};

  void add(const Mesh& mesh, const std::array<double, 3>& colour) {
    for (const Triangle& t : mesh.triangles) {
      const Vec3 across =
          cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
      const double own_m2 = length(across) / 2;
      area_m2 += own_m2;
      if (std::abs(unit(across).z) > 0.1) continue;
      wall_m2 += own_m2;
      for (std::size_t c = 0; c < 3; ++c) light[c] += own_m2 * colour[c];
    }
  }
};

Shown shown_by(const GeneratedBuilding& house) {
  Shown shown;
  for (const MaterialMesh& mesh : house.meshes) {
    const auto& base = values_of(mesh.material).base_colour;
    shown.add(mesh.mesh,
              {base[0] * mesh.tint[0] / 255.0, base[1] * mesh.tint[1] / 255.0, base[2] * mesh.tint[2] / 255.0});
  }
  for (const TexturedFace& face : house.textured_faces) {
    const auto light = mean(unpacked(*face.picture)).light;
    shown.add(face.mesh.mesh, {light[0] / 65535.0, light[1] / 65535.0, light[2] / 65535.0});
  }
  return shown;
}

bool is_glass(const impostor::Texel& texel) { return texel.roughness < 100; }

// Memory grows with the texels that are rendered, not with those that are kept.
TEST(FacadeTextures, AreRenderedWithALimitedNumberOfTexels) {
  impostor::View wall, kilometres;
  wall.texel_m = 5, wall.columns = 4, wall.rows = 2;
  kilometres.texel_m = 5, kilometres.columns = 800, kilometres.rows = 600;
  EXPECT_GT(halvings_for(wall), 0u);
  EXPECT_LE(5.0 / (1u << halvings_for(wall)), 0.4 * impostor::kSamplesPerSide);
  EXPECT_LE((std::uint64_t{kilometres.columns} * kilometres.rows) << (2 * halvings_for(kilometres)), kMaxTexelsPerFace);
}

TEST(FacadeTextures, ShowWindows) {
  for (const Style style : {Style::kPanelBlock, Style::kOldTownHouse, Style::kOfficeSlab}) {
    const GeneratedBuilding block = expanded(building_of_style(style, 30, 18), 0.5);
    std::size_t with_windows = 0;
    for (const TexturedFace& face : block.textured_faces) {
      const auto texels = unpacked(*face.picture).texels;
      if (std::ranges::any_of(texels, is_glass) && !std::ranges::all_of(texels, is_glass)) ++with_windows;
    }
    EXPECT_GE(with_windows, 2u) << static_cast<int>(style);
  }
}

TEST(FacadeTextures, AreAsBrightAsTheGeometryTheyReplace) {
  // reveals, and what stands on the roof, are walls too where they are geometry: light ones
  const Building block = building_of_style(Style::kOfficeSlab, 30, 18);
  const Shown fine = shown_by(expanded(block, 0.25));
  for (const double tolerance_m : {0.5, 2.5, 12.5}) {
    const Shown coarse = shown_by(expanded(block, tolerance_m));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(coarse.light[c] / coarse.wall_m2, fine.light[c] / fine.wall_m2, 0.09) << tolerance_m;
  }
}

// A style of which about one in two buildings has balconies.
Building with_iron_balconies() {
  Building block = building_of_style(Style::kCourtyardBlock, 30, 21);
  block.facade_edges.resize(4);
  block.facade_edges[0].faces_street = true;
  return block;
}

// The area of vertical faces in front of the facade, the plane y = 0: railings and the edges of slabs.
double balconies_m2(const GeneratedBuilding& house) {
  Shown shown;
  for (const MaterialMesh& mesh : house.meshes) {
    Mesh before = mesh.mesh;
    std::erase_if(before.triangles, [&](const Triangle& t) {
      return std::ranges::any_of(t, [&](std::uint32_t v) { return before.positions[v].y > -0.85; });
    });
    shown.add(before, {});
  }
  return shown.wall_m2;
}

// If railings were faces, these would have five times the area of their bars.
TEST(FacadeTextures, ReplaceRailingsByRails) {
  Building block = with_iron_balconies();
  std::size_t houses_with_balconies = 0;
  for (std::int64_t id = 1; id <= 12; ++id) {
    block.id.osm.id = id;
    const double bars_m2 = balconies_m2(expanded(block, 0.05));
    if (bars_m2 == 0) continue;
    ++houses_with_balconies;
    const GeneratedBuilding coarse = expanded(block, 0.5);
    EXPECT_GT(balconies_m2(coarse), 0.4 * bars_m2) << id;
    EXPECT_LT(balconies_m2(coarse), bars_m2) << id;
    EXPECT_LE(coarse.error_m, 0.5);
  }
  EXPECT_GE(houses_with_balconies, 3u);
}

TEST(FacadeTextures, HaveCoordinatesInsideThePicture) {
  std::size_t faces = 0;
  for (const double tolerance_m : {0.5, 2.5, 12.5})
    for (const TexturedFace& face :
         expanded(building_of_style(Style::kOldTownHouse, 17.3, 16), tolerance_m).textured_faces) {
      ++faces;
      EXPECT_EQ(face.mesh.colour_source, materials::ColourSource::kByAtlas);
      ASSERT_EQ(face.mesh.uvs.size(), face.mesh.mesh.positions.size());
      for (const Vec2 uv : face.mesh.uvs) {
        EXPECT_TRUE(uv.x > -1e-6 && uv.x < face.picture->columns * tolerance_m + 1e-6);
        EXPECT_TRUE(uv.y > -1e-6 && uv.y < face.picture->rows * tolerance_m + 1e-6);
      }
    }
  EXPECT_GT(faces, 0u);
}

TEST(FacadeTextures, HaveNoGaps) {
  const GeneratedBuilding villa = expanded(building_of_style(Style::kVilla, 12, 7), 0.5);
  ASSERT_FALSE(villa.textured_faces.empty());
  for (const TexturedFace& face : villa.textured_faces)
    for (const impostor::Picture seen = unpacked(*face.picture); const impostor::Texel& texel : seen.texels)
      EXPECT_GT(texel.shown, 0);
}

TEST(FacadeTextures, HaveAtLeastTheLeastTexels) {
  for (const TexturedFace& face : expanded(building_of_style(Style::kPanelBlock, 40, 18), 12.5).textured_faces)
    EXPECT_GE(face.picture->columns * face.picture->rows, kMinTexels);
  for (const TexturedFace& face : expanded(building_of_style(Style::kRowHouse, 8, 7), 2.5).textured_faces)
    EXPECT_GE(face.picture->columns * face.picture->rows, kMinTexels);
}

TEST(FacadeTextures, NeedFewTriangles) {
  const GeneratedBuilding block = expanded(building_of_style(Style::kPanelBlock, 45, 18), 2.5);
  std::size_t triangles = 0;
  for (const MaterialMesh& mesh : block.meshes) triangles += mesh.mesh.triangles.size();
  for (const TexturedFace& face : block.textured_faces) triangles += face.mesh.mesh.triangles.size();
  EXPECT_LE(triangles, 40u);
  EXPECT_LE(block.error_m, 2.5);
}

bool are_same(const Mesh& a, const Mesh& b) { return a.positions == b.positions && a.triangles == b.triangles; }

TEST(FacadeTextures, AreTheSameForLevelsTogetherAndAlone) {
  const Building block = building_of_style(Style::kCourtyardBlock, 24, 19);
  const double tolerances_m[] = {0.1, 0.5, 2.5, 12.5};
  std::vector<Report> reports(std::size(tolerances_m));
  const std::vector<GeneratedBuilding> together = generate(block, rulebook(), {1}, tolerances_m, reports);
  ASSERT_EQ(together.size(), std::size(tolerances_m));
  for (std::size_t l = 0; l < together.size(); ++l) {
    const GeneratedBuilding alone = expanded(block, tolerances_m[l]);
    ASSERT_EQ(together[l].meshes.size(), alone.meshes.size());
    ASSERT_EQ(together[l].textured_faces.size(), alone.textured_faces.size());
    EXPECT_TRUE(alone.textured_faces.empty() || has_detail(Detail::kFacadeTextures, tolerances_m[l]));
    for (std::size_t i = 0; i < alone.meshes.size(); ++i)
      EXPECT_TRUE(are_same(together[l].meshes[i].mesh, alone.meshes[i].mesh));
    for (std::size_t i = 0; i < alone.textured_faces.size(); ++i) {
      EXPECT_EQ(*together[l].textured_faces[i].picture, *alone.textured_faces[i].picture);
      EXPECT_TRUE(are_same(together[l].textured_faces[i].mesh.mesh, alone.textured_faces[i].mesh.mesh));
    }
  }
}

TEST(FacadeTextures, AreNotMadeWithoutRules) {
  EXPECT_TRUE(expanded(building_of_style(Style::kPlain, 30, 18), 2.5).textured_faces.empty());
}

// ---- at night

// The mean emission over a triangle of a textured face.
double emission_on(const TexturedFace& face, const Triangle& t, double texel_m) {
  constexpr int kSteps = 64;
  double sum = 0;
  int count = 0;
  const impostor::Picture seen = unpacked(*face.picture);
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; i + j < kSteps; ++j) {
      const double a = (i + 1 / 3.0) / kSteps, b = (j + 1 / 3.0) / kSteps;
      const Vec2 uv = face.mesh.uvs[t[0]] * (1 - a - b) + face.mesh.uvs[t[1]] * a + face.mesh.uvs[t[2]] * b;
      const auto at = [&](double m, std::uint32_t most) { return std::clamp<int>(m / texel_m, 0, most - 1); };
      const std::size_t row = at(uv.y, seen.rows), column = at(uv.x, seen.columns);
      sum += seen.texels[row * seen.columns + column].emission[0] / 65535.0;
      ++count;
    }
  return sum / count;
}

double triangle_area_m2(const Mesh& mesh, const Triangle& t) {
  return length(cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]])) / 2;
}

// The light that a building emits: emission times area.
double light_of(const GeneratedBuilding& house, double texel_m) {
  double sum = 0;
  for (const MaterialMesh& part : house.meshes)
    for (const Triangle& t : part.mesh.triangles) sum += triangle_area_m2(part.mesh, t) * emission_of(part.material)[0];
  for (const TexturedFace& face : house.textured_faces)
    for (const Triangle& t : face.mesh.mesh.triangles)
      sum += triangle_area_m2(face.mesh.mesh, t) * emission_on(face, t, texel_m);
  return sum;
}

// On a Wednesday at 18:00.
constexpr WeekTime kEvening{2 * 24 + 18};

GeneratedBuilding by_night(const Building& building, double tolerance_m) {
  Report report;
  return generate(building, rulebook(), {1, kEvening}, tolerance_m, report);
}

TEST(LitWindows, EmitLightAtNightAlone) {
  for (int style = 0; style < static_cast<int>(Style::kCount); ++style)
    EXPECT_EQ(light_of(expanded(building_of_style(static_cast<Style>(style), 30, 18), 0.1), 0.1), 0) << style;
  for (const Style style : {Style::kPanelBlock, Style::kCourtyardBlock, Style::kOfficeSlab, Style::kGlassTower})
    EXPECT_GT(light_of(by_night(building_of_style(style, 30, 18), 0.1), 0.1), 1) << static_cast<int>(style);
}

TEST(LitWindows, AreTheShareOfTheHour) {
  const Building block = building_of_style(Style::kPanelBlock, 60, 30);
  const auto glass_m2 = [](const GeneratedBuilding& house) {
    double sum = 0;
    for (const MaterialMesh& mesh : house.meshes)
      if (mesh.material == Material::kGlass) sum += shown_by({{mesh}, 0}).wall_m2;
    return sum;
  };
  const double dark = glass_m2(by_night(block, 0.1)) / glass_m2(expanded(block, 0.1));
  EXPECT_NEAR(dark, 1 - lit_window_share(Use::kHome, kEvening), 0.12);
}

// The light that the walls of a building emit: its finest level seen from straight ahead, without what stands in front
// of the walls.
double light_through_walls(const Building& block) {
  std::vector<MaterialMesh> meshes = by_night(block, 0.02).meshes;
  const impostor::Model shape = impostor::model_of(meshes);
  const Ring& ring = block.footprint.outer;
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
    impostor::View view{at_height(from, block.top_m), at_height(unit(to - from), 0), {0, 0, -1}, 0.1};
    view.columns = static_cast<std::uint32_t>(length(to - from) * 10);
    view.rows = static_cast<std::uint32_t>(block.top_m * 10);
    view.before_m = 0.02, view.behind_m = 0.6;
    const impostor::Picture seen = impostor::render(shape, view).picture;
    for (const impostor::Texel& texel : seen.texels) sum += texel.emission[0] / 65535.0 * 0.01;
  }
  return sum;
}

// Neither balconies in front of windows nor their positions within texels change the light.
TEST(LitWindows, EmitTheSameLightOnEveryLevel) {
  for (const Style style : {Style::kOldTownHouse, Style::kCourtyardBlock, Style::kRowHouse, Style::kVilla,
                            Style::kPanelBlock, Style::kOfficeSlab, Style::kGlassTower}) {
    for (const double width_m : {21.0, 44.0}) {
      const Building block =
          building_of_style(style, width_m, style == Style::kRowHouse || style == Style::kVilla ? 6.5 : 30);
      const double fine = light_through_walls(block);
      EXPECT_GT(fine, 1) << rule_file_of(style);
      for (const double tolerance_m : {0.5, 2.5, 12.5}) {
        // low houses are dropped
        if (tolerance_m > block.top_m) continue;
        EXPECT_NEAR(light_of(by_night(block, tolerance_m), tolerance_m) / fine, 1, 0.15)
            << rule_file_of(style) << " " << width_m << " m wide at " << tolerance_m << " m";
      }
    }
  }
}

}  // namespace
}  // namespace citykiln::buildings

#include "compiler/buildings/meshes/railings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/buildings/meshes/terminal_meshes.h"
#include "compiler/materials/texture.h"
#include "grammars/language/read_rules.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using materials::Material;
using materials::MaterialMesh;

// A railing of 1 m height on a wall that stands obliquely.
Face railing_of(double width_m) {
  const Vec3 x = unit(Vec3{3, 1, 0}), at{1234.5, -98.25, 40};
  Face railing;
  railing.outer = {at, at + x * width_m, at + x * width_m + Vec3{0, 0, 1}, at + Vec3{0, 0, 1}};
  return railing;
}

MaterialMesh panel_of(const Face& railing) {
  MaterialMesh mesh{{}, Material::kRailing, materials::kNoTint, {}};
  add_face(railing, mesh);
  return mesh;
}

// The texture's opacity at a share of the panel's width and height.
int opacity_at(const materials::Texture& texture, const MaterialMesh& panel, double along, double up) {
  const Vec2 low = panel.uvs[0], high = panel.uvs[2];
  const Vec2 at{low.x + (high.x - low.x) * along, low.y + (high.y - low.y) * up};
  const auto column = static_cast<std::size_t>(std::floor(at.x / texture.colour.texel_m)) % texture.colour.columns;
  const auto row = static_cast<std::size_t>(std::floor(at.y / texture.colour.texel_m)) % texture.colour.rows;
  return texture.opacity[row * texture.colour.columns + column];
}

TEST(Railings, HaveBarsWhereTheTextureIsOpaque) {
  const materials::Texture texture = texture_of(Material::kRailing, 0.1, 1);
  ASSERT_EQ(texture.opacity.size(), texture.colour.texels.size());
  for (const double width_m : {0.3, 1.0, 2.4}) {
    const Face railing = railing_of(width_m);
    const MaterialMesh panel = panel_of(railing);
    const Vec3 corner = railing.outer[0], along = unit(railing.outer[1] - corner);
    const std::vector<Face> parts = parts_of_railing(railing);
    double last = -1;
    for (std::size_t i = 0; i + 3 < parts.size(); i += 2) {
      const double from = dot(parts[i].outer[0] - corner, along), to = dot(parts[i].outer[1] - corner, along);
      EXPECT_NEAR(to - from, 0.02, 0.006);
      EXPECT_GE(opacity_at(texture, panel, (from + to) / 2 / width_m, 0.5), 128);
      if (last >= 0) {
        EXPECT_NEAR(from - last, 0.12, 0.03);
        EXPECT_LT(opacity_at(texture, panel, (last + from) / 2 / width_m, 0.5), 128);
      }
      last = to;
    }
    EXPECT_NEAR(last, width_m, 1e-9);
  }
}

TEST(Railings, HaveARailAboveAndAGapBelow) {
  const materials::Texture texture = texture_of(Material::kRailing, 0.1, 1);
  const MaterialMesh panel = panel_of(railing_of(1.3));
  for (double along = 0.01; along < 1; along += 0.01) {
    EXPECT_GE(opacity_at(texture, panel, along, 0.98), 128);
    EXPECT_LT(opacity_at(texture, panel, along, 0.03), 128);
  }
}

TEST(Railings, AreOpaqueInTheShareOfTheirBars) {
  const materials::Texture texture = texture_of(Material::kRailing, 0.1, 1);
  const auto solid = static_cast<double>(std::ranges::count(texture.opacity, 255));
  EXPECT_NEAR(solid / static_cast<double>(texture.opacity.size()), 0.05 + 0.02 / 0.14, 0.06);
}

TEST(Railings, AreTwoTrianglesAtCoarseTolerances) {
  const auto program = grammars::read_rules_of("Lot --> color(\"#2f3435\") set(material.name, \"railing\") Bars.");
  ASSERT_TRUE(program);
  const Polygon footprint{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {}};
  const grammars::Derivation derivation = derive(*program, grammars::lot(footprint, 2, 0, StableId{1}, {0}), {});
  const auto coarse = terminal_meshes(derivation, {}, 0.1), fine = terminal_meshes(derivation, {}, 0.05);
  ASSERT_EQ(coarse.size(), 1u);
  ASSERT_EQ(fine.size(), 1u);
  EXPECT_EQ(coarse[0].mesh.triangles.size(), 2u);
  EXPECT_EQ(coarse[0].uvs.size(), 4u);
  EXPECT_GT(fine[0].mesh.triangles.size(), 40u);
  EXPECT_TRUE(fine[0].uvs.empty());
}

}  // namespace
}  // namespace citykiln::buildings

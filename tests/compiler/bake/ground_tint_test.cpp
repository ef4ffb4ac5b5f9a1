#include "compiler/bake/ground_tint.h"

#include <gtest/gtest.h>

#include <set>

#include "compiler/bake/border_shade.h"

namespace citykiln::bake {
namespace {

using ground::Surface;
using map::SurfaceClass;
using materials::Material;
using materials::Tint;

ground::Surface surface_of(SurfaceClass surface, std::int64_t id) { return {{{OsmType::kWay, id}, 0}, surface, 1, {}}; }

TEST(GroundTint, FieldsDiffer) {
  std::set<Tint> tints;
  for (int id = 0; id < 40; ++id)
    tints.insert(tint_of(shade_of(surface_of(SurfaceClass::kFarmland, id), Material::kFarmland, 1), {}));
  EXPECT_GT(tints.size(), 30u);
}

TEST(GroundTint, GrassIsDullerInWinterAndFieldsAreBarer) {
  const plants::Month january{1};
  double winter = 0, summer = 0;
  for (int id = 0; id < 40; ++id) {
    const Surface lawn = surface_of(SurfaceClass::kGrass, id), field = surface_of(SurfaceClass::kFarmland, id);
    EXPECT_LT(shade_of(lawn, Material::kGrass, 1, january).green, shade_of(lawn, Material::kGrass, 1).green);
    winter += shade_of(field, Material::kFarmland, 1, january).red;
    summer += shade_of(field, Material::kFarmland, 1).red;
  }
  EXPECT_LT(winter, summer);
  const Surface road = surface_of(SurfaceClass::kPrimaryRoad, 1), rock = surface_of(SurfaceClass::kBareRock, 1);
  EXPECT_EQ(shade_of(road, Material::kAsphalt, 1, january).green, shade_of(road, Material::kAsphalt, 1).green);
  EXPECT_EQ(shade_of(rock, Material::kRock, 1, january).green, shade_of(rock, Material::kRock, 1).green);
}

TEST(GroundTint, PavedSurfacesAreOneWhateverTheyWereMappedAs) {
  for (int id = 0; id < 9; ++id)
    EXPECT_EQ(tint_of(shade_of(surface_of(SurfaceClass::kPrimaryRoad, id), Material::kAsphalt, 1), {}),
              materials::kNoTint);
}

TEST(GroundTint, OnlyDarkensAndNeverToBlack) {
  for (int m = 0; m < static_cast<int>(Material::kCount); ++m)
    for (int i = 0; i < 200; ++i) {
      const auto material = static_cast<Material>(m);
      const Shade at = shade_at({37.0 * i, -91.0 * i}, material, 1);
      for (const double v : {at.red, at.green, at.blue}) {
        EXPECT_LE(v, 1);
        EXPECT_GT(v, 0.4);
      }
    }
}

TEST(GroundTint, OfAPlaceChangesSlowly) {
  for (double x = 0; x < 2000; x += 1) {
    const Shade a = shade_at({x, 5}, Material::kGrass, 1), b = shade_at({x + 1, 5}, Material::kGrass, 1);
    EXPECT_LT(std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue), 0.06);
  }
}

TEST(GroundTint, WaterHasNone) {
  for (int i = 0; i < 50; ++i) EXPECT_EQ(tint_of({}, shade_at({90.0 * i, 7}, Material::kSea, 1)), materials::kNoTint);
}

// Two squares of meadow and forest side by side from x = 10 to 30, and the line they share at 20.
struct TwoAreas {
  std::vector<ground::Surface> surfaces = {surface_of(SurfaceClass::kMeadow, 1), surface_of(SurfaceClass::kForest, 2)};
  ground::GroundMesh ground;

  explicit TwoAreas(double west_m = 10) {
    for (const double y : {0.5, 10.5})
      for (const double x : {0.0, 10.0, 20.0}) ground.mesh.positions.push_back({west_m + x, y, 0});
    ground.mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    ground.face_surface = {0, 0, 1, 1};
  }
};

bool equal(Shade a, Shade b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }

TEST(BorderShade, IsTheMeanWhereSoftAreasMeet) {
  const TwoAreas two;
  const BorderShades border = border_shades(two.ground, two.surfaces, 1);
  const Shade a = shade_of(two.surfaces[0], Material::kMeadow, 1),
              b = shade_of(two.surfaces[1], Material::kForestFloor, 1);
  for (const std::size_t v : {1u, 4u}) {
    EXPECT_TRUE(border.is_shared[v]);
    EXPECT_NEAR(border.shades[v].red, (a.red + b.red) / 2, 1e-12);
    EXPECT_NEAR(border.shades[v].blue, (a.blue + b.blue) / 2, 1e-12);
  }
  for (const std::size_t v : {0u, 2u, 3u, 5u}) EXPECT_FALSE(border.is_shared[v]);
}

TEST(BorderShade, DoesNotDependOnTheOrderOfFaces) {
  TwoAreas two;
  const BorderShades one = border_shades(two.ground, two.surfaces, 1);
  std::reverse(two.ground.mesh.triangles.begin(), two.ground.mesh.triangles.end());
  std::reverse(two.ground.face_surface.begin(), two.ground.face_surface.end());
  const BorderShades other = border_shades(two.ground, two.surfaces, 1);
  for (std::size_t v = 0; v < 6; ++v) EXPECT_TRUE(equal(one.shades[v], other.shades[v]));
}

TEST(BorderShade, FieldsKeepTheirEdges) {
  TwoAreas two;
  two.surfaces[1] = surface_of(SurfaceClass::kFarmland, 2);
  for (const bool is_shared : border_shades(two.ground, two.surfaces, 1).is_shared) EXPECT_FALSE(is_shared);
}

// the cell beyond sees other faces, and must tint these vertices alike
TEST(BorderShade, NothingIsSharedOnACellsBorder) {
  const TwoAreas two(118);  // the line they share lies at x = 128
  for (const bool is_shared : border_shades(two.ground, two.surfaces, 1).is_shared) EXPECT_FALSE(is_shared);
}

}  // namespace
}  // namespace citykiln::bake

#include "compiler/bake/ground/ground_tint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/bake/ground/border_tint.h"

namespace citykiln::bake {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverClass;
using materials::Material;
using materials::Tint;

ground::LandCoverPolygon surface_of(LandCoverClass surface, std::int64_t id) {
  return {{{OsmType::kWay, id}, 0}, surface, 1, {}};
}

TEST(GroundTint, FieldsDiffer) {
  std::set<Tint> tints;
  for (int id = 0; id < 40; ++id)
    tints.insert(tint_of(surface_tint(surface_of(LandCoverClass::kFarmland, id), Material::kFarmland, 1), {}));
  EXPECT_GT(tints.size(), 30u);
}

TEST(GroundTint, GrassIsDullerInWinterAndFieldsAreBarer) {
  const plants::Month january{1};
  double winter = 0, summer = 0;
  for (int id = 0; id < 40; ++id) {
    const LandCoverPolygon lawn = surface_of(LandCoverClass::kGrass, id),
                           field = surface_of(LandCoverClass::kFarmland, id);
    EXPECT_LT(surface_tint(lawn, Material::kGrass, 1, january).green, surface_tint(lawn, Material::kGrass, 1).green);
    winter += surface_tint(field, Material::kFarmland, 1, january).red;
    summer += surface_tint(field, Material::kFarmland, 1).red;
  }
  EXPECT_LT(winter, summer);
  const LandCoverPolygon road = surface_of(LandCoverClass::kPrimaryRoad, 1),
                         rock = surface_of(LandCoverClass::kBareRock, 1);
  EXPECT_EQ(surface_tint(road, Material::kAsphalt, 1, january).green, surface_tint(road, Material::kAsphalt, 1).green);
  EXPECT_EQ(surface_tint(rock, Material::kRock, 1, january).green, surface_tint(rock, Material::kRock, 1).green);
}

TEST(GroundTint, PavedSurfacesAreOneWhateverTheyWereMappedAs) {
  for (int id = 0; id < 9; ++id)
    EXPECT_EQ(tint_of(surface_tint(surface_of(LandCoverClass::kPrimaryRoad, id), Material::kAsphalt, 1), {}),
              materials::kNoTint);
}

TEST(GroundTint, OnlyDarkensAndNeverToBlack) {
  for (int m = 0; m < static_cast<int>(Material::kCount); ++m)
    for (int i = 0; i < 200; ++i) {
      const auto material = static_cast<Material>(m);
      const TintFactor at = place_tint({37.0 * i, -91.0 * i}, material, 1);
      for (const double v : {at.red, at.green, at.blue}) {
        EXPECT_LE(v, 1);
        EXPECT_GT(v, 0.4);
      }
    }
}

TEST(GroundTint, OfAPlaceChangesSlowly) {
  for (double x = 0; x < 2000; x += 1) {
    const TintFactor a = place_tint({x, 5}, Material::kGrass, 1), b = place_tint({x + 1, 5}, Material::kGrass, 1);
    EXPECT_LT(std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue), 0.06);
  }
}

TEST(GroundTint, WaterHasNone) {
  for (int i = 0; i < 50; ++i) EXPECT_EQ(tint_of({}, place_tint({90.0 * i, 7}, Material::kSea, 1)), materials::kNoTint);
}

// Two squares of meadow and forest side by side from x = 10 to 30, and the line they share at 20.
struct TwoAreas {
  std::vector<ground::LandCoverPolygon> surfaces = {surface_of(LandCoverClass::kMeadow, 1),
                                                    surface_of(LandCoverClass::kForest, 2)};
  ground::GroundMesh ground;

  explicit TwoAreas(double west_m = 10) {
    for (const double y : {0.5, 10.5})
      for (const double x : {0.0, 10.0, 20.0}) ground.mesh.positions.push_back({west_m + x, y, 0});
    ground.mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    ground.face_cover = {0, 0, 1, 1};
  }
};

bool equal(TintFactor a, TintFactor b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }

TEST(BorderTints, IsTheMeanWhereSoftAreasMeet) {
  const TwoAreas two;
  const BorderTints border = border_tints(two.ground, two.surfaces, 1);
  const TintFactor a = surface_tint(two.surfaces[0], Material::kMeadow, 1),
                   b = surface_tint(two.surfaces[1], Material::kForestFloor, 1);
  for (const std::size_t v : {1u, 4u}) {
    EXPECT_TRUE(border.is_shared[v]);
    EXPECT_NEAR(border.tints[v].red, (a.red + b.red) / 2, 1e-12);
    EXPECT_NEAR(border.tints[v].blue, (a.blue + b.blue) / 2, 1e-12);
  }
  for (const std::size_t v : {0u, 2u, 3u, 5u}) EXPECT_FALSE(border.is_shared[v]);
}

TEST(BorderTints, DoesNotDependOnTheOrderOfFaces) {
  TwoAreas two;
  const BorderTints one = border_tints(two.ground, two.surfaces, 1);
  std::reverse(two.ground.mesh.triangles.begin(), two.ground.mesh.triangles.end());
  std::reverse(two.ground.face_cover.begin(), two.ground.face_cover.end());
  const BorderTints other = border_tints(two.ground, two.surfaces, 1);
  for (std::size_t v = 0; v < 6; ++v) EXPECT_TRUE(equal(one.tints[v], other.tints[v]));
}

TEST(BorderTints, FieldsKeepTheirEdges) {
  TwoAreas two;
  two.surfaces[1] = surface_of(LandCoverClass::kFarmland, 2);
  const std::vector<bool> is_shared = border_tints(two.ground, two.surfaces, 1).is_shared;
  EXPECT_FALSE(is_shared.empty());
  EXPECT_EQ(std::ranges::count(is_shared, true), 0);
}

// the neighbouring cell has other faces and must give these vertices the same tint
TEST(BorderTints, NothingIsSharedOnACellsBorder) {
  const TwoAreas two(118);  // the line they share lies at x = 128
  const std::vector<bool> is_shared = border_tints(two.ground, two.surfaces, 1).is_shared;
  EXPECT_FALSE(is_shared.empty());
  EXPECT_EQ(std::ranges::count(is_shared, true), 0);
}

}  // namespace
}  // namespace citykiln::bake

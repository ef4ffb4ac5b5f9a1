#include "compiler/bake/ground/dry_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/bake/ground/ground_material.h"

namespace citykiln::bake {
namespace {

using ground::DryShares;
using map::LandCoverClass;
using materials::Material;

constexpr LandCoverClass kCovers[] = {LandCoverClass::kUnknown, LandCoverClass::kGrass,       LandCoverClass::kMeadow,
                                      LandCoverClass::kPark,    LandCoverClass::kResidential, LandCoverClass::kScrub,
                                      LandCoverClass::kVerge,   LandCoverClass::kForest};

// The linear colour that is shown.
TintFactor shown(LandCoverClass cover, const DryShares& dry) {
  const Material material = dry_material_of(cover, dry);
  const auto& base = materials::values_of(material).base_colour;
  const bool is_dry = material == Material::kDryGround || material == Material::kDryGrass;
  return times({base[0], base[1], base[2]}, is_dry ? dry_tint(cover, dry) : TintFactor{});
}

TEST(DryGround, IsTheClassesOwnMaterialWhereNothingIsDry) {
  for (const LandCoverClass cover : kCovers) EXPECT_EQ(dry_material_of(cover, {}), values_of(cover).material);
}

TEST(DryGround, IsStrawAndThenSoil) {
  EXPECT_EQ(dry_material_of(LandCoverClass::kMeadow, {0.9, 0}), Material::kDryGrass);
  EXPECT_EQ(dry_material_of(LandCoverClass::kUnknown, {0.7, 0.9}), Material::kDryGround);
}

TEST(DryGround, ChangesItsColourWithoutAStep) {
  for (const LandCoverClass cover : kCovers) {
    TintFactor before = shown(cover, {});
    for (int i = 1; i <= 200; ++i) {
      const TintFactor now = shown(cover, {i / 200.0, i / 200.0});
      EXPECT_NEAR(now.red, before.red, 0.02) << values_of(cover).name << ' ' << i;
      EXPECT_NEAR(now.green, before.green, 0.02) << values_of(cover).name << ' ' << i;
      EXPECT_NEAR(now.blue, before.blue, 0.02) << values_of(cover).name << ' ' << i;
      before = now;
    }
  }
}

TEST(DryGround, IsRockOnSteepSlopesAndSnowAboveTheSnowLine) {
  const DryShares desert{0.9, 1};
  const auto face = [&](double rise, double z_m) {
    return GroundFace{
        .surface = LandCoverClass::kUnknown, .normal = unit(Vec3{-rise, 0, 1}), .centre = {64, 64, z_m}, .dry = desert};
  };
  EXPECT_EQ(material_of(face(0.1, 100), {}, 1), Material::kDryGround);
  EXPECT_EQ(material_of(face(1.5, 100), {}, 1), Material::kRock);
  EXPECT_EQ(material_of(face(0.1, 3000), 2000, 1), Material::kSnow);
}

}  // namespace
}  // namespace citykiln::bake

#include "compiler/bake/ground_material.h"

#include <gtest/gtest.h>

namespace citykiln::bake {
namespace {

using map::SurfaceClass;
using materials::Material;

// A face whose steepest line rises by so much a metre.
GroundFace face(SurfaceClass surface, double rise, double z_m = 100, bool is_beside_road = false) {
  return {surface, unit(Vec3{-rise, 0, 1}), {64, 64, z_m}, is_beside_road};
}

constexpr double kSteep = 1.3, kCliff = 5, kGentle = 0.9;  // 52, 79 and 42 degrees
constexpr SurfaceClass kAll[] = {SurfaceClass::kUnknown,   SurfaceClass::kForest, SurfaceClass::kMeadow,
                                 SurfaceClass::kFarmland,  SurfaceClass::kPark,   SurfaceClass::kScrub,
                                 SurfaceClass::kWetland,   SurfaceClass::kBeach,  SurfaceClass::kResidential,
                                 SurfaceClass::kIndustrial};

TEST(GroundMaterial, IsTheClassesOwnOnGentleSlopes) {
  for (int s = 0; s < static_cast<int>(SurfaceClass::kCount); ++s) {
    const auto surface = static_cast<SurfaceClass>(s);
    for (const double rise : {0.0, kGentle})
      EXPECT_EQ(material_of(face(surface, rise), {}, 1), values_of(surface).material);
  }
}

TEST(GroundMaterial, SteepLandIsRockAndMasonryInTownsAndBesideRoads) {
  for (const SurfaceClass surface : kAll) {
    const map::SurfaceGroup group = values_of(surface).group;
    const bool is_town = group == map::SurfaceGroup::kTown || group == map::SurfaceGroup::kIndustry ||
                         group == map::SurfaceGroup::kGarden;
    for (const double rise : {kSteep, kCliff}) {
      EXPECT_EQ(material_of(face(surface, rise), {}, 1), is_town ? Material::kStone : Material::kRock);
      EXPECT_EQ(material_of(face(surface, rise, 100, true), {}, 1), Material::kStone);
    }
  }
}

TEST(GroundMaterial, WhatIsBuiltAndWaterKeepTheirsAtAnySlopeAndHeight) {
  for (const SurfaceClass surface :
       {SurfaceClass::kPrimaryRoad, SurfaceClass::kFootPath, SurfaceClass::kRailway, SurfaceClass::kKerb,
        SurfaceClass::kLake, SurfaceClass::kSea, SurfaceClass::kPitch, SurfaceClass::kBuilding, SurfaceClass::kSquare})
    for (const double rise : {0.0, kSteep, kCliff})
      EXPECT_EQ(material_of(face(surface, rise, 4000), 1000, 1), values_of(surface).material);
}

TEST(GroundMaterial, SnowLiesAboveTheLineWhereOneIsAskedFor) {
  for (const SurfaceClass surface : kAll) {
    EXPECT_EQ(material_of(face(surface, 0.3, 4000), {}, 1), values_of(surface).material);
    EXPECT_EQ(material_of(face(surface, 0.3, 2000 + kSnowLineSway_m), 2000, 1), Material::kSnow);
    EXPECT_EQ(material_of(face(surface, 0.3, 2000 - kSnowLineSway_m - 1), 2000, 1), values_of(surface).material);
    EXPECT_EQ(material_of(face(surface, kSteep, 2500), 2000, 1), Material::kSnow);
  }
}

TEST(GroundMaterial, UprightLandIsBuiltOfStoneAndNeverSnowed) {
  for (const SurfaceClass surface : kAll) {
    GroundFace wall = face(surface, 0, 4000);
    wall.normal = {1, 0, 0}, wall.is_upright = true;
    EXPECT_EQ(material_of(wall, 1000, 1), Material::kStone);
  }
}

TEST(GroundMaterial, SnowSlidesOffCliffs) {
  EXPECT_EQ(material_of(face(SurfaceClass::kFell, kCliff, 2500), 2000, 1), Material::kRock);
}

}  // namespace
}  // namespace citykiln::bake

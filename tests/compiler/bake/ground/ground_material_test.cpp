#include "compiler/bake/ground/ground_material.h"

#include <gtest/gtest.h>

namespace citykiln::bake {
namespace {

using map::LandCoverClass;
using materials::Material;

// A face of this slope, in metres per metre.
GroundFace face(LandCoverClass surface, double rise, double z_m = 100, bool is_beside_road = false) {
  return {surface, unit(Vec3{-rise, 0, 1}), {64, 64, z_m}, is_beside_road};
}

constexpr double kSteep = 1.3, kCliff = 5, kGentle = 0.9;  // 52, 79 and 42 degrees
constexpr LandCoverClass kAll[] = {LandCoverClass::kUnknown,   LandCoverClass::kForest, LandCoverClass::kMeadow,
                                   LandCoverClass::kFarmland,  LandCoverClass::kPark,   LandCoverClass::kScrub,
                                   LandCoverClass::kWetland,   LandCoverClass::kBeach,  LandCoverClass::kResidential,
                                   LandCoverClass::kIndustrial};

TEST(GroundMaterial, IsTheClassesOwnOnGentleSlopes) {
  for (int s = 0; s < static_cast<int>(LandCoverClass::kCount); ++s) {
    const auto surface = static_cast<LandCoverClass>(s);
    for (const double rise : {0.0, kGentle})
      EXPECT_EQ(material_of(face(surface, rise), {}, 1), values_of(surface).material);
  }
}

TEST(GroundMaterial, SteepLandIsRockAndMasonryInTownsAndBesideRoads) {
  for (const LandCoverClass surface : kAll) {
    const map::LandCoverGroup group = values_of(surface).group;
    const bool is_town = group == map::LandCoverGroup::kTown || group == map::LandCoverGroup::kIndustry ||
                         group == map::LandCoverGroup::kGarden;
    for (const double rise : {kSteep, kCliff}) {
      EXPECT_EQ(material_of(face(surface, rise), {}, 1), is_town ? Material::kStone : Material::kRock);
      EXPECT_EQ(material_of(face(surface, rise, 100, true), {}, 1), Material::kStone);
    }
  }
}

TEST(GroundMaterial, OnlySteepUnmappedLandIsWild) {
  const auto of = [](LandCoverClass surface, double rise, bool is_beside_road = false) {
    GroundFace wild = face(surface, rise, 100, is_beside_road);
    wild.wild = Material::kScrub;
    return material_of(wild, {}, 1);
  };
  EXPECT_EQ(of(LandCoverClass::kUnknown, 0.6), Material::kScrub);  // 31 degrees
  EXPECT_EQ(of(LandCoverClass::kUnknown, 0.3), Material::kUnknownGround);
  EXPECT_EQ(of(LandCoverClass::kUnknown, 0.6, true), Material::kUnknownGround);
  EXPECT_EQ(of(LandCoverClass::kUnknown, kSteep), Material::kRock);
  EXPECT_EQ(of(LandCoverClass::kMeadow, 0.6), Material::kMeadow);
  EXPECT_EQ(of(LandCoverClass::kResidential, 0.6), values_of(LandCoverClass::kResidential).material);
}

TEST(GroundMaterial, WhatIsBuiltAndWaterKeepTheirsAtAnySlopeAndHeight) {
  for (const LandCoverClass surface :
       {LandCoverClass::kPrimaryRoad, LandCoverClass::kFootPath, LandCoverClass::kRailway, LandCoverClass::kKerb,
        LandCoverClass::kLake, LandCoverClass::kSea, LandCoverClass::kPitch, LandCoverClass::kBuilding,
        LandCoverClass::kSquare})
    for (const double rise : {0.0, kSteep, kCliff})
      EXPECT_EQ(material_of(face(surface, rise, 4000), 1000, 1), values_of(surface).material);
}

TEST(GroundMaterial, SnowLiesAboveTheLineWhereOneIsAskedFor) {
  for (const LandCoverClass surface : kAll) {
    EXPECT_EQ(material_of(face(surface, 0.3, 4000), {}, 1), values_of(surface).material);
    EXPECT_EQ(material_of(face(surface, 0.3, 2000 + kSnowLineSway_m), 2000, 1), Material::kSnow);
    EXPECT_EQ(material_of(face(surface, 0.3, 2000 - kSnowLineSway_m - 1), 2000, 1), values_of(surface).material);
    EXPECT_EQ(material_of(face(surface, kSteep, 2500), 2000, 1), Material::kSnow);
  }
}

TEST(GroundMaterial, UprightLandIsBuiltOfStoneAndNeverSnowed) {
  for (const LandCoverClass surface : kAll) {
    GroundFace wall = face(surface, 0, 4000);
    wall.normal = {1, 0, 0}, wall.is_vertical = true;
    EXPECT_EQ(material_of(wall, 1000, 1), Material::kStone);
  }
}

TEST(GroundMaterial, SnowSlidesOffCliffs) {
  EXPECT_EQ(material_of(face(LandCoverClass::kFell, kCliff, 2500), 2000, 1), Material::kRock);
}

}  // namespace
}  // namespace citykiln::bake

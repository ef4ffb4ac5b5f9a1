// What the ground is covered with. Every face of the ground has exactly one class.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/materials/material.h"

namespace citykiln::map {

/// Rows of surface_classes.inc. The order is part of the manifest's format: add at the end.
enum class LandCoverClass : std::uint8_t {
#define LAND_COVER(name, group, priority, material) name,
#include "compiler/map/land_cover_classes.inc"
#undef LAND_COVER
  kCount
};

/// The groups of WORKS.md E and the ones that roads and buildings add.
enum class LandCoverGroup : std::uint8_t {
  kUnknown,
  kForest,
  kGrassland,
  kFarm,
  kGarden,
  kScrubland,
  kWetland,
  kWater,
  kBare,
  kTown,
  kIndustry,
  kSport,
  kPaved,
  kRoad,
  kPath,
  kRail,
  kBuilding
};

struct LandCoverValues {
  std::string_view name;  ///< "ConiferousForest".
  LandCoverGroup group;
  std::uint8_t
      priority;  ///< Where surfaces overlap the higher one wins; among equals the smaller area, then the lower id.
  materials::Material material;
};

const LandCoverValues& values_of(LandCoverClass surface);

}  // namespace citykiln::map

// Land cover classes. Every face of the ground has exactly one.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/materials/material.h"

namespace citykiln::map {

/// Rows of land_cover_classes.inc. Their order is part of the manifest's format: add at the end.
enum class LandCoverClass : std::uint8_t {
#define LAND_COVER(name, group, priority, material) name,
#include "compiler/map/land_cover_classes.inc"
#undef LAND_COVER
  kCount
};

/// Groups of classes: land uses, and the surfaces of roads and buildings.
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

/// A row of land_cover_classes.inc.
struct LandCoverValues {
  std::string_view name;  ///< Such as "ConiferousForest".
  LandCoverGroup group;
  /// Where polygons overlap, the higher priority wins, then the smaller area, then the lower id; an area that lies in a
  /// larger one is above it (ground/cover/contained_areas.h).
  std::uint8_t priority;
  materials::Material material;
};

/// Returns the row of a class.
const LandCoverValues& values_of(LandCoverClass surface);

/// True for the crops of assumed fields and for the pieces of meadows: kCereals to kHayMeadow.
constexpr bool is_field(LandCoverClass surface) {
  return surface >= LandCoverClass::kCereals && surface <= LandCoverClass::kHayMeadow;
}

/// Roads form junctions only with roads of their family: a footpath that ends on a street makes no junction. kOther
/// (rails, runways) has no junctions at all.
enum class Family : std::uint8_t { kStreet, kPath, kOther };
Family family_of(LandCoverClass surface);

/// True for roads of cars and lorries: all of LandCoverGroup::kRoad but runways.
bool is_street(LandCoverClass surface);

}  // namespace citykiln::map

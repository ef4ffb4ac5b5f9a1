// Building classes: uses of buildings that differ in appearance.
#pragma once

#include <cstdint>
#include <string_view>

namespace citykiln::map {

/// Rows of building_classes.inc.
enum class BuildingClass : std::uint8_t {
#define BUILDING(name, height_m, level_m) name,
#include "compiler/map/buildings/building_classes.inc"
#undef BUILDING
  kCount
};

/// A row of building_classes.inc.
struct BuildingValues {
  std::string_view name;
  double height_m;  ///< The default height; 0: it follows from the footprint's area.
  double level_m;   ///< Height of a storey.
};

const BuildingValues& values_of(BuildingClass building);

/// The name of a class in output files; "Building" for kPlain.
std::string_view word_of(BuildingClass building);

/// Returns the class of a value of building=* or building:part=*: of the first word in it that has one; kPlain for
/// other values.
BuildingClass building_class_of(std::string_view value);

}  // namespace citykiln::map

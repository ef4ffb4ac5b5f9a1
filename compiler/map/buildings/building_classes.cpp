#include "compiler/map/buildings/building_classes.h"

#include <cassert>

#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

constexpr BuildingValues kBuildingValues[] = {
#define BUILDING(name, height_m, level_m) {std::string_view(#name).substr(1), height_m, level_m},
#include "compiler/map/buildings/building_classes.inc"
#undef BUILDING
};

struct ValueRow {
  std::string_view value;
  BuildingClass building;
};

constexpr ValueRow kValues[] = {
#define VALUE(value, building) {value, BuildingClass::building},
#include "compiler/map/buildings/building_values.inc"
#undef VALUE
};

}  // namespace

const BuildingValues& values_of(BuildingClass building) {
  assert(building < BuildingClass::kCount);
  return kBuildingValues[static_cast<std::size_t>(building)];
}

std::string_view word_of(BuildingClass building) {
  return building == BuildingClass::kPlain ? "Building" : values_of(building).name;
}

BuildingClass building_class_of(std::string_view value) {
  if (const ValueRow* row = row_with(kValues, value)) return row->building;
  return first_known(value,
                     [](std::string_view word) {
                       const ValueRow* row = row_with(kValues, word);
                       return row != nullptr ? std::optional(row->building) : std::nullopt;
                     })
      .value_or(BuildingClass::kPlain);
}

}  // namespace citykiln::map

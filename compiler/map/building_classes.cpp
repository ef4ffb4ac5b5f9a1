#include "compiler/map/building_classes.h"

namespace citykiln::map {
namespace {

constexpr BuildingValues kTable[] = {
#define BUILDING(name, height_m, level_m) {std::string_view(#name).substr(1), height_m, level_m},
#include "compiler/map/building_classes.inc"
#undef BUILDING
};

struct ValueRow {
  std::string_view value;
  BuildingClass building;
};

constexpr ValueRow kValues[] = {
#define VALUE(value, building) {value, BuildingClass::building},
#include "compiler/map/building_values.inc"
#undef VALUE
};

}  // namespace

const BuildingValues& values_of(BuildingClass building) { return kTable[static_cast<std::size_t>(building)]; }

BuildingClass building_class_of(std::string_view value) {
  for (const ValueRow& row : kValues)
    if (row.value == value) return row.building;
  return BuildingClass::kPlain;
}

}  // namespace citykiln::map

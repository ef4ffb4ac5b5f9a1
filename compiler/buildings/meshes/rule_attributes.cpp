#include "compiler/buildings/meshes/rule_attributes.h"

#include "compiler/contract/texts/hex_colour.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

// "RoofTile" becomes "roof_tile".
std::string snake_case(std::string_view camel) {
  std::string name;
  for (const char c : camel) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    if (is_capital && !name.empty()) name += '_';
    name += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return name;
}

std::string material_name(materials::Material material) { return snake_case(materials::values_of(material).name); }

// Light variants have the names of the materials whose look they have: rules choose by colour again.
std::string wall_name(materials::Material wall) {
  constexpr std::string_view kLight = "light_";
  const std::string name = material_name(wall);
  return name.starts_with(kLight) ? name.substr(kLight.size()) : name;
}

std::string name_of_class(std::uint8_t building_class) {
  return snake_case(map::values_of(static_cast<map::BuildingClass>(building_class)).name);
}

std::string region_of(const Building& building) {
  return has(building.assumed, Assumption::kStyles) ? std::string(map::name_of(building.country)) : "";
}

}  // namespace

std::map<std::string, grammars::Value> rule_attributes_of(const Building& building, roofs::RoofForm roof) {
  return {{"building", name_of_class(building.building_class)},
          {"height", eaves_m(building) - building.floor_m},
          {"levels", static_cast<double>(building.levels)},
          {"shop", building.has_shop && building.stands_on_ground},
          {"attached", !building.party_walls.empty()},
          {"year", static_cast<double>(building.year)},
          {"wall_colour", hex_colour(building.wall_colour)},
          {"wall_material", wall_name(building.wall)},
          {"roof_colour", hex_colour(building.roof_colour)},
          {"roof_material", material_name(building.roof)},
          {"roof", std::string(roofs::name_of(roof))},
          {"lifted", !building.stands_on_ground},
          {"region", region_of(building)}};
}

}  // namespace citykiln::buildings

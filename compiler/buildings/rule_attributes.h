// What rules are told of a building: the attributes that grammars/rules/README.md lists.
#pragma once

#include <map>
#include <string>

#include "compiler/buildings/recipe.h"
#include "grammars/language/value.h"

namespace citykiln::buildings {

/// All but `night` and `entrances`: building, height, levels, shop, attached, year, wall_colour, wall_material,
/// roof_colour, roof_material, roof. Colours that nobody told are "".
std::map<std::string, grammars::Value> rule_attributes_of(const Building& building, roofs::Form roof);

}  // namespace citykiln::buildings

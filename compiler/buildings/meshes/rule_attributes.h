// The attributes of a building that rules can read, as listed in grammars/rules/README.md.
#pragma once

#include <map>
#include <string>

#include "compiler/buildings/recipe.h"
#include "grammars/language/value.h"

namespace citykiln::buildings {

/// Returns all attributes but `night`, `shop_lit`, `entrances` and `fronts`, which the caller adds. Untagged colours
/// are "".
std::map<std::string, grammars::Value> rule_attributes_of(const Building& building, roofs::RoofForm roof);

}  // namespace citykiln::buildings

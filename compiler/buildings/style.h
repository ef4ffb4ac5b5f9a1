// By which rules a building's walls become facades.
#pragma once

#include <string_view>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// By class, age, size, and whether it is attached to others; kPlain for what is too small, or stands on nothing.
Style style_of(const map::Footprint& footprint, const Building& building);

/// "old_town_house": the rule file's name without its ending; "" of kPlain.
std::string_view rule_file_of(Style style);

}  // namespace citykiln::buildings

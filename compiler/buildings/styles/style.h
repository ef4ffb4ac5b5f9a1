// Chooses the facade style of a building.
#pragma once

#include <string_view>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Returns the style by class, year, size and party walls (walls shared with a neighbour), and if Assumption::kStyles
/// is among those of the footprint, for dwellings by country group and for tall and old buildings by share
/// (mixed_styles.h); kPlain for walls too small for a window.
Style style_of(const map::Footprint& footprint, const Building& building);

/// Returns the rule file of a style without extension ("old_town_house"); "" for kPlain.
std::string_view rule_file_of(Style style);

}  // namespace citykiln::buildings

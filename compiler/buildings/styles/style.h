// Chooses the facade style of a building.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Returns the style whose rule file has this name without extension; empty if there is none, as for "".
std::optional<Style> style_named(std::string_view rule_file);

/// Returns the style that the footprint names (style_name), else the style by class, year, size and party walls (walls
/// shared with a neighbour), and if Assumption::kStyles is among those of the footprint, for dwellings by country group
/// and for tall and old buildings by share (mixed_styles.h); kPlain for walls too small for a window.
Style style_of(const map::Footprint& footprint, const Building& building);

/// Returns the rule file of a style without extension ("old_town_house"); "" for kPlain.
std::string_view rule_file_of(Style style);

}  // namespace citykiln::buildings

// Mixes styles of several times and kinds, so that the buildings of a town differ: for buildings with the mark
// Assumption::kStyles.
#pragma once

#include <cstdint>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Returns the style of a building by the rows of mixed_styles.inc that fit it: each gives its share of the buildings
/// another style, and the rest keeps `usual`. The draw depends on the id of the footprint, or of the outline that it
/// is a part of, so that all parts of a building agree. O(rows).
/// @param usual   The style that regional_style() or the building's class gives.
Style mixed_style(const map::Footprint& footprint, const Building& building, Style usual);

/// Returns the material of walls without a tagged material for a style of mixed_styles.inc; `usual` for other styles.
/// @param draw  The building's random number, from 0 to 99.
materials::Material mixed_wall(Style style, materials::Material usual, std::uint32_t draw);

}  // namespace citykiln::buildings

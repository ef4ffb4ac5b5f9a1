// Chooses the styles and materials of dwellings by country group, for buildings with the mark Assumption::kStyles.
#pragma once

#include <cstdint>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Returns the style of a dwelling in a country group, by the first row of regional_styles.inc that fits; `usual` if
/// none fits. O(rows).
/// @param usual   The style that the same building has in central Europe.
/// @param levels  Its number of storeys, Building::levels.
Style regional_style(map::CountryGroup country, Style usual, std::uint8_t levels);

/// Returns the material of walls without a tagged material, for a style in a country group; `usual` without a row.
/// @param draw  The building's random number, from 0 to 99.
materials::Material regional_wall(map::CountryGroup country, Style style, materials::Material usual,
                                  std::uint32_t draw);

/// Returns the material of a pitched roof in a country group, if it has no tagged or assumed material and would be of
/// tiles in central Europe.
/// @param draw  The building's random number, from 0 to 99.
materials::Material regional_roof(map::CountryGroup country, std::uint32_t draw);

/// Returns the largest area of a house's footprint in a country group; larger dwellings are blocks of flats.
double max_house_m2(map::CountryGroup country);

}  // namespace citykiln::buildings

// The styles and materials of dwellings by country group, where they are assumed (Assumption::kStyles).
#pragma once

#include <cstdint>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Returns the style that dwellings have in a country group instead of one that they have in central Europe
/// (regional_styles.inc); `usual` where no row fits. O(rows).
Style regional_style(map::CountryGroup country, Style usual, std::uint8_t levels);

/// The material of untagged walls of a style in a country group; `usual` without a row. A draw is from 0 to 99.
materials::Material regional_wall(map::CountryGroup country, Style style, materials::Material usual,
                                  std::uint32_t draw);

/// The material of untagged pitched roofs in a country group, where they are of tiles in central Europe.
materials::Material regional_roof(map::CountryGroup country, std::uint32_t draw);

/// The largest footprint of a house in a country group; larger dwellings are blocks of flats.
double max_house_m2(map::CountryGroup country);

}  // namespace citykiln::buildings

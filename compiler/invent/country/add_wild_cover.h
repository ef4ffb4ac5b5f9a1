// Woods, rock, scree, heath and grassland, by slope, height and noise.
#pragma once

#include <cstdint>

#include "compiler/invent/country/country_settings.h"
#include "compiler/invent/country/taken_land.h"
#include "compiler/invent/invented_map.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// Adds wild land cover to a map and to the taken land, which is indexed again. Areas keep off towns and roads by some
/// metres. With fields, the rest stays free; without, it becomes grassland.
void add_wild_cover(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                    TakenLand& taken, InventedMap& map);

}  // namespace citykiln::invent

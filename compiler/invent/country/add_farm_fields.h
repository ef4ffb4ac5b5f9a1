// Fields, meadows and orchards with hedges between them.
#pragma once

#include <cstdint>

#include "compiler/invent/country/country_settings.h"
#include "compiler/invent/country/taken_land.h"
#include "compiler/invent/invented_map.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// Divides the land that is free within a square into fields: the square is split by lines along the nearest road, or
/// along the contour on slopes, until pieces are as large as fields; each piece loses the land that is taken. Hedges
/// and single trees stand on the lines of splits.
///
/// Guarantees: fields share no area with each other or with taken land, except for 1 cm of rounding.
void add_farm_fields(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                     const TakenLand& taken, InventedMap& map);

}  // namespace citykiln::invent

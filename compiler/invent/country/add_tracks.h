// Farm and forest tracks, and footpaths.
#pragma once

#include <cstdint>

#include "compiler/invent/country/country_settings.h"
#include "compiler/invent/invented_map.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// Adds tracks between roads, the border of the square and places in it, by least cost over slope and water. Later
/// tracks follow earlier ones, so that they form a network; steep ones are footpaths.
///
/// Guarantees: tracks meet each other and roads in equal points, and cross no road, no town and no water wider than a
/// ford or a culvert. Method: Galin, Peytavie, Maréchal, Guérin, "Procedural Generation of Roads", Eurographics 2010,
/// on a grid with eight directions. O(tracks · n log n) in points of the grid.
void add_tracks(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                InventedMap& map);

}  // namespace citykiln::invent

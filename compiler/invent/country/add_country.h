// The country around towns: fields, hedges, woods, tracks, and the land cover of worlds without a town.
#pragma once

#include <cstdint>

#include "compiler/invent/country/country_settings.h"
#include "compiler/invent/invented_map.h"
#include "compiler/invent/terrain.h"

namespace citykiln::invent {

/// Adds rivers, lakes and coasts of a terrain to a map, within a square about the middle of the world.
void add_water(const Terrain& terrain, double side_m, InventedMap& map);

/// Adds the land cover that the map leaves free within a square about the middle of the world: woods by slope, height
/// and noise, rock where it is steep, heath beside woods, and between them fields and meadows with hedges, orchards,
/// farm tracks and rows of trees.
///
/// Lakes must be in the map already (add_water()). Tracks are written first, then wild cover, then fields.
/// Roads are lines of the map with highway or railway; land of towns is areas with landuse, leisure, amenity or
/// building. Guarantees: fields overlap neither each other, nor towns, water, or woods, and keep off roads.
/// Cost: about 0.2 s a square kilometre.
void add_country(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                 InventedMap& map);

}  // namespace citykiln::invent

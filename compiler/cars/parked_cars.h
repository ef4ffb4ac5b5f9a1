// Parked cars of a tile: a share of the parking places that its recipes give, where nothing is in the way.
//
// A place is in the tile that contains its middle. In this order, places are left out that
//   1. at streets, lie in a junction, at a crossing or before a drive; or that a trunk stands in (clear_zones.h);
//   2. lie on unsuitable ground (has_ground());
//   3. overlap a place of an earlier kind, or of their own kind with a lower key, even if that is left out itself;
//   4. at streets, lie at a stop; or that reach to a door, a barrier or a thing.
// The first three depend on data that all tiles near a place have, so they decide alike. Mapped spaces are known to
// their own tile alone: a place of another tile counts before them, and they count before those of their own tile. The
// fourth step also needs what one tile alone knows; it is the last one, so it changes nothing for others.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/buildings/lit_windows.h"
#include "compiler/cars/place.h"
#include "compiler/cars/recipe.h"
#include "compiler/roadside/clear_zones.h"
#include "compiler/roadside/tile_recipes.h"

namespace citykiln::cars {

/// The settings that decide which places have a car.
struct CarSettings {
  CarShare share;
  buildings::WeekTime time;
  map::CountryGroup country{};  ///< The country of places that belong to no road or yard.
  std::uint64_t seed = 0;
};

/// Returns the places of a tile where a car may stand, sorted by kind and key.
///
/// Guarantees: disjoint boxes share no places. Two places overlap by more than 0.0625 m in no tile, and across a border
/// of two tiles only if both are mapped spaces that overlap on the map. O(places + roads).
/// @param zones  clear_zones_of() the recipes.
/// @param box    The tile; lower sides inclusive, upper sides exclusive.
std::vector<Place> places_in(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                             const CarSettings& settings, const Box2& box);

/// Returns the rectangles of all taken places whose middles lie in a box, also of those that places_in() leaves out for
/// what one tile alone knows: a superset of the parked cars there, equal in all tiles near the box.
std::vector<OrientedRect> taken_places(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       const CarSettings& settings, const Box2& box);

/// Returns the cars of a tile as things, in the order of their places. A car stands within its place, to 0.01 m, at
/// most 1 degree askew. Depends on the seed, the hour and the settings; not on threads.
std::vector<things::Thing> parked_cars(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       const CarSettings& settings, const Box2& box);

}  // namespace citykiln::cars

// Moving cars of a tile, which stand still in their lanes as in a photograph.
//
// A place of a lane (lane_places.h) is in the tile that contains its middle. Places are left out that
//   1. lie on other ground than their own carriageway, or beside rails (has_ground());
//   2. overlap a place with a parked car;
//   3. overlap another one with a lower key, even if that is left out itself.
// All of these depend on data that all tiles near a place have, so they decide alike; also things and barriers in a
// carriageway, which one tile alone knows, are kept clear, last.
#pragma once

#include <vector>

#include "compiler/cars/lane_places.h"
#include "compiler/cars/parked_cars.h"

namespace citykiln::cars {

/// Returns the moving cars of a tile as things, sorted by key. Depends on the seed, the hour and the settings; not on
/// threads. O(length of roads + places).
/// @param zones   clear_zones_of() the recipes.
/// @param parked  The settings of the tile's parked cars.
/// @param box     The tile.
std::vector<things::Thing> moving_cars(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       const TrafficSettings& settings, const CarSettings& parked, const Box2& box);

}  // namespace citykiln::cars

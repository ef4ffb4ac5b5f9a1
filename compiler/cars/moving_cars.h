// Moving cars of a tile, which stand still in their lanes as in a photograph.
//
// A place of a lane (lane_places.h) is in the tile that contains its middle. Places are left out that
//   1. lie on other ground than their own carriageway, or beside rails (has_ground());
//   2. overlap a taken parking place (taken_places());
//   3. overlap another one that passes 1 and 2 and has a lower key, even if rule 3 leaves that out itself.
// All tiles near a place have the data for these rules, so they decide alike. Each tile then leaves out those that
// overlap barriers or things in a carriageway, which it alone knows.
#pragma once

#include <vector>

#include "compiler/cars/lane_places.h"
#include "compiler/cars/parked_cars.h"

namespace citykiln::cars {

/// Returns the moving cars of a tile as things, sorted by key. The result depends on the recipes and settings only, not
/// on the number of threads. O(length of roads + places).
/// @param zones   clear_zones_of() the recipes.
/// @param parked  The settings of the tile's parked cars.
/// @param box     The tile.
std::vector<things::Thing> moving_cars(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       const TrafficSettings& settings, const CarSettings& parked, const Box2& box);

}  // namespace citykiln::cars

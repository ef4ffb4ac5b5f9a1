// Clear zones: ground that parked cars and street furniture keep clear. These are junctions, crossings, drives, doors,
// stops, and all that stands there.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/oriented_rect.h"
#include "compiler/lots/mapped_things.h"
#include "compiler/roadside/tile_recipes.h"

namespace citykiln::roadside {

/// The distances from junctions of three or more through streets, from all other junctions of streets, and from
/// crossings, bus and tram stops, hydrants and gates. StVO, paragraph 12: 5 m before crossings and at junctions;
/// paragraph 41, sign 224: 15 m at stops, 10 m here as buses in most countries need. Uniform Vehicle Code, paragraph
/// 11-1003: 15 feet from hydrants.
inline constexpr double kFromJunction_m = 5, kFromDrive_m = 1, kFromCrossing_m = 5, kFromStop_m = 10,
                        kFromHydrant_m = 4.5, kFromGate_m = 3;
/// The distance from doors, and from the middle of lamps.
inline constexpr double kFromDoor_m = 1.5, kFromLamp_m = 0.75;
/// Things lower than this are driven and walked over, such as manholes.
inline constexpr double kLowThing_m = 0.1;

/// The clear zones of a tile and its surroundings.
struct ClearZones {
  lots::Capsules streets;   ///< Junctions, crossings, and the ways out of drives. Equal in all tiles near them.
  lots::Capsules trunks;    ///< The trunks of trees. Equal in all tiles near them.
  lots::Capsules stops;     ///< Stops, hydrants and gates of the tile, which cars at kerbs keep clear.
  lots::Capsules doors;     ///< The doors of the tile's buildings.
  lots::Capsules barriers;  ///< Walls, fences and hedges.
  lots::Capsules lamps;     ///< The lamps of the tile.
  RectIndex things;         ///< The plans of the tile's things on the ground, without mapped parking spaces.
};

/// Returns the clear zones. O(n log n) in recipes.
ClearZones clear_zones_of(const TileRecipes& recipes);

/// True if a rectangle is outside of all zones: tested is the largest capsule in the rectangle, so its corners may
/// reach into a zone. O(zones near).
bool is_clear(const lots::Capsules& zones, const OrientedRect& rect);

/// Returns the plan of a thing: the rectangle of its width across its direction and its depth along it.
OrientedRect plan_of(const things::Thing& thing);

}  // namespace citykiln::roadside

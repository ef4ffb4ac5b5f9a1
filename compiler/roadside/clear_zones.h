// Clear zones: ground that parked cars, furniture, street trees and utility poles keep clear. They surround junctions,
// crossings, drives, doors, stops, trunks, barriers, lamps and things.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/oriented_rect.h"
#include "compiler/lots/mapped_things.h"
#include "compiler/roadside/tile_recipes.h"

namespace citykiln::roadside {

/// The radii of clear zones in metres: at junctions with three or more arms of through streets, at other junctions of
/// streets, at crossings, at bus and tram stops, at hydrants and at gates. StVO, paragraph 12: 5 m before crossings and
/// at junctions; paragraph 41, sign 224: 15 m at stops, here 10 m as buses in most countries need. Uniform Vehicle
/// Code, paragraph 11-1003: 15 feet from hydrants.
inline constexpr double kFromJunction_m = 5, kFromDrive_m = 1, kFromCrossing_m = 5, kFromStop_m = 10,
                        kFromHydrant_m = 4.5, kFromGate_m = 3;
/// The distance from doors, and from the middle of lamps.
inline constexpr double kFromDoor_m = 1.5, kFromLamp_m = 0.75;
/// Things lower than this, such as manholes, have no zone, in metres.
inline constexpr double kLowThing_m = 0.1;

/// The clear zones of a tile and its surroundings.
struct ClearZones {
  lots::Capsules streets;   ///< Junctions, crossings and drives up to the kerb. Equal in tiles within 32 m of them.
  lots::Capsules trunks;    ///< Trunks. Equal in all tiles near them, except those of assumed street trees.
  lots::Capsules stops;     ///< Stops, hydrants and gates of the tile, which cars along streets keep clear.
  lots::Capsules doors;     ///< The doors of the tile's buildings.
  lots::Capsules barriers;  ///< Walls, fences and hedges.
  lots::Capsules lamps;     ///< The lamps of the tile.
  RectIndex things;         ///< Bases of the tile's things on the ground from kLowThing_m high, without parking spaces.
};

/// Returns the clear zones. O(n log n) in recipes.
ClearZones clear_zones_of(const TileRecipes& recipes);

/// True if no zone touches the largest capsule inside a rectangle. Its corners may reach into a zone. O(zones near).
bool is_clear(const lots::Capsules& zones, const OrientedRect& rect);

/// Returns the base of a thing: its width across its direction, its depth along it.
OrientedRect plan_of(const things::Thing& thing);

}  // namespace citykiln::roadside

// Ground that parked cars keep clear: junctions, crossings, drives, doors, stops, and all that stands there.
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/cars/place.h"
#include "compiler/lots/mapped_things.h"
#include "compiler/lots/recipe.h"
#include "compiler/plants/recipe.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/things/recipe.h"

namespace citykiln::cars {

/// The distances of cars at kerbs from the ends of junctions and from crossings, bus and tram stops, hydrants and
/// gates. StVO, paragraph 12: 5 m before crossings and at junctions; paragraph 41, sign 224: 15 m at stops, 10 m here
/// as buses in most countries need. Uniform Vehicle Code, paragraph 11-1003: 15 feet from hydrants.
inline constexpr double kFromJunction_m = 5, kFromCrossing_m = 5, kFromStop_m = 10, kFromHydrant_m = 4.5,
                        kFromGate_m = 3;
/// The distance of all parked cars from doors.
inline constexpr double kFromDoor_m = 1.5;

/// True if a place is outside of all clearings, which are capsules. O(clearings near).
bool is_clear(const lots::Capsules& kept, const Place& place);

/// Returns the clearings of streets: ends of junctions, crossings, and the ways out of drives. Junctions with service
/// roads and drives alone keep 1 m.
/// @param tile_m  Side of the tiles (roads::stretches_of()).
std::vector<lots::Capsule> street_clearings(std::span<const roads::Road> roads,
                                            std::span<const roads::Junction> junctions,
                                            std::span<const lots::Yard> yards, double tile_m);

/// Returns the clearings of stops, hydrants and gates, for cars at kerbs.
std::vector<lots::Capsule> stop_clearings(std::span<const things::Thing> things);

/// Returns the trunks of mapped trees.
std::vector<lots::Capsule> trunk_clearings(std::span<const plants::Tree> trees);

/// Returns what stands on the ground: things other than mapped parking spaces, walls and fences; and doors.
std::vector<lots::Capsule> solid_clearings(std::span<const things::Thing> things,
                                           std::span<const props::Barrier> barriers,
                                           std::span<const buildings::Building> buildings);

}  // namespace citykiln::cars

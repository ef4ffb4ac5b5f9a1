// Rims of swimming pools: a strip of stone around each pool, a little above its water.
//
//      _____           _____      The rim is level. The land beside it meets its height, as it meets the level of
//     rim   |_________|    rim    other standing water.
//              water
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The width of a pool's rim, and its height above the water.
inline constexpr double kPoolRim_m = 0.3, kPoolRimRise_m = 0.125;

/// Adds a polygon for the rim of each pool, with the pool's id and a part of its own; pools lie on top of rims. A pool
/// without a level, on a map without heights, gets the level 0.
///
/// @param surfaces  The polygons, with the levels of standing water.
/// Guarantees: sorted by id if the given ones are. O(n log n) in vertices of pools.
std::vector<LandCoverPolygon> with_pool_rims(std::vector<LandCoverPolygon> surfaces);

}  // namespace citykiln::ground

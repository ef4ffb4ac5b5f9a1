// Finds waterways that are mapped uphill.
#pragma once

#include <vector>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// Returns for each line that is clearly mapped uphill the height by which it would rise; 0 for other lines.
///
/// Lines of which each begins where the one before ends, and nothing else meets them, are a chain: one waterway in
/// parts, culverts included. A chain is clearly mapped uphill if its last third is at least 10 m above its first third,
/// and one direction would need four times as much fill as the other. The 10 m are 3 m if it begins in the sea, and
/// 30 m if it continues other waterways, as these are rarely mapped wrong. All lines of a chain have its height.
/// O(stations).
///
/// @param seas  Per standing water: true if it is the sea.
std::vector<double> uphill_rise_m(const RiverNetwork& network, const std::vector<bool>& seas);

}  // namespace citykiln::ground

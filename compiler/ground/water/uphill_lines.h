// Finds waterways that are mapped uphill.
#pragma once

#include <vector>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// Returns for each line that is clearly mapped uphill the height by which it would rise, in
/// metres; 0 for other lines.
///
/// A chain is one waterway mapped in parts, with culverts: lines of which each begins where the one
/// before ends, where nothing else meets them. Its rise is the mean terrain of its last third less
/// that of its first third. A chain is clearly mapped uphill if the rise is at least
///
/// - 3 m, if it begins in the sea;
/// - 30 m, if other waterways lead into its start and on from its end, since such chains are rarely
///   mapped wrong;
/// - 10 m in all other cases,
///
/// and if water needs more than four times as much fill to run in the mapped direction as in the
/// other one. All lines of a chain have its rise. Stations without known terrain do not count.
/// O(stations).
///
/// @param seas  Per standing water: true if it is the sea.
std::vector<double> uphill_rise_m(const RiverNetwork& network, const std::vector<bool>& seas);

}  // namespace citykiln::ground

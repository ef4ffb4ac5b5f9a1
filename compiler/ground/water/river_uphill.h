// Finds waterways that are mapped uphill.
#pragma once

#include <vector>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// Returns per line how far it would rise if it ran as mapped, where the terrain clearly says that it runs the other
/// way; else 0. Clearly: its last third lies at least 10 m above its first (3 m where it begins in the sea; 30 m where
/// it continues another line, which is rarely mapped wrong), and one direction would need four times as much fill as
/// the other. O(stations).
///
/// @param seas  Per water: whether it is the sea.
std::vector<double> uphill_rise_m(const RiverNetwork& network, const std::vector<bool>& seas, std::size_t stream_count);

}  // namespace citykiln::ground

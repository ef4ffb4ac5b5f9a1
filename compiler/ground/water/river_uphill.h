// Waterways that are mapped uphill.
#pragma once

#include <vector>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// How much each line would rise if it ran as it is mapped, where the land says clearly that it runs the other way;
/// else 0. Clearly: its last third lies at least 10 m above its first (3 m where it begins in the sea; 30 m where it
/// goes on from one line to the next, which is rarely wrong), and four times as much land would have to be filled for
/// one direction as for the other. O(stops).
///
/// @param seas  For each water, whether it is the sea.
std::vector<double> uphill_rise_m(const RiverNetwork& network, const std::vector<bool>& seas, std::size_t stream_count);

}  // namespace citykiln::ground

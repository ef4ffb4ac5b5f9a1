// Finds the heights of all nodes of a river network: places along watercourses, and lakes as one node each.
#pragma once

#include <vector>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// The cost of a metre of water above the terrain, if a metre below costs 1, and 2 below the lowest land across the
/// line. With a higher cost less water stands above pits of the terrain, and cuts beside the pits are deeper.
inline constexpr int kAboveCost = 3;
/// The largest depth and the largest height that smoothing adds.
inline constexpr double kMaxSmoothing_m = 4, kMaxSmoothingLift_m = 1;

struct RiverHeights {
  std::vector<double> height_m;  ///< Per node.
  std::vector<bool> is_cycle;    ///< Per node: true on a cycle, except for standing water.
};

/// Fits heights that never rise downstream to the terrain, then smooths them.
///
/// @param seas   For each standing water: true if it is the sea.
/// @param apart  Per line of the network: true if water does not run through it. Nodes of such lines alone have the
///               terrain's height.
///
/// Method: (1) Each cycle is contracted to one node and so becomes level, since downstream is an order only without
/// cycles. (2) fit_descending() with kAboveCost, so that a level part of a river is at the lower quartile of its
/// terrain. (3) Rounds in which a node moves towards the lowest node upstream and the highest node downstream, which
/// keeps heights descending. Smoothing never lifts water above all terrain upstream of it, lifts it at most
/// kMaxSmoothingLift_m and cuts at most kMaxSmoothing_m deeper; standing water, springs and ends stay.
///
/// Guarantees: no node is lower than a node downstream of it; the sea is at 0. Priorities: descent, then levels of
/// standing water, then the terrain. A pit of width w lowers the river beside it by no more than its bed falls over
/// kAboveCost · w. O(n log² n).
RiverHeights find_river_heights(const RiverNetwork& network, const std::vector<bool>& seas,
                                const std::vector<bool>& apart);

/// Returns the heights of the stops of one line as if there were no other, not smoothed. O(stops log² stops).
std::vector<double> heights_alone(const RiverNetwork& network, const RiverLine& line, const std::vector<bool>& seas);

}  // namespace citykiln::ground

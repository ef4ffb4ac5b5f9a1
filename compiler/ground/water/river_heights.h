// Heights of all nodes of a river network.
#pragma once

#include <vector>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// The cost of a metre of water above the terrain; a metre below costs 1. More means fewer dams of water over pits and
/// deeper cuts beside them.
inline constexpr int kAboveCost = 3;
inline constexpr double kMaxSmoothing_m = 4;

struct RiverHeights {
  std::vector<double> height_m;  ///< Per node.
  std::vector<bool> is_cycle;    ///< Nodes on a cycle other than standing water.
};

/// Fits heights that never rise downstream to the terrain, then smooths them.
///
/// Method: (1) cycles are contracted to one node, hence level: only then is downstream an order; (2) fit_descending()
/// with kAboveCost above the terrain, so that water lies at the lower quarter of what it pools; (3) rounds in which a
/// node moves towards the lowest of the nodes upstream and the highest of those downstream, which keeps heights
/// descending. Smoothing never lifts water above all terrain upstream of it and cuts at most kMaxSmoothing_m deeper;
/// standing water, springs and ends stay.
/// Guarantees: no node lies lower than one downstream of it; the sea lies at 0. Priorities: descent, then levels of
/// standing water, then the terrain. A pit of width w lowers the river beside it by no more than its bed falls over
/// kAboveCost · w. O(n log² n).
RiverHeights find_river_heights(const RiverNetwork& network, const std::vector<bool>& seas);

}  // namespace citykiln::ground

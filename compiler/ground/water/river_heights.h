// Heights of all nodes of a river network.
#pragma once

#include <vector>

#include "compiler/ground/water/river_network.h"

namespace citykiln::ground {

/// What a metre of water above the land costs, where a metre below it costs 1: the more, the fewer dams of water over
/// pits, the deeper the cuts beside them.
inline constexpr int kAboveCost = 3;
inline constexpr double kMaxSmoothing_m = 4;

struct RiverHeights {
  std::vector<double> height_m;  ///< By node.
  std::vector<bool> is_cycle;    ///< Nodes that water reaches again after leaving them, other than standing water.
};

/// Fits heights that never rise downstream to the land, then smooths them.
///
/// Method: circles are level; fit_descending, a metre above the land costing kAboveCost times what a metre below does,
/// so that the water lies at the lower quarter of what it pools; then rounds in which each node moves towards the lower
/// of the nodes before it and the higher of those after it, which keeps them falling. Smoothing never lifts water above
/// all land upstream of it and never cuts deeper than kMaxSmoothing_m; standing water, springs and ends stay.
/// Guarantees: no node lies lower than one downstream of it; the sea lies at 0. What wins: falling, then standing
/// water's levels, then the land. A pit w wide in the land lowers the river beside it by no more than its bed falls
/// over kAboveCost w. O(n log² n).
RiverHeights find_river_heights(const RiverNetwork& network, const std::vector<bool>& seas);

}  // namespace citykiln::ground

// Junctions are flat plates: on each arm the heights follow one plane from the place to the cut.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/profile_graph.h"

namespace citykiln::ground {

/// No junction is steeper than this, whichever way, nor than the limit of any of its roads.
inline constexpr double kPlaneSlope = 0.08;
/// What a plane moves its arms' ends by is spread over as much road as keeps it below 1 in kSpread, between these.
inline constexpr double kSpread = 20, kMinSpread_m = 16, kMaxSpread_m = 64;

struct JunctionPlanes {
  std::vector<double> z_m;     ///< By node.
  std::vector<Vec2> gradient;  ///< By node: of its junction's plane, zero off junctions.
};

/// Fits a plane to each junction's nodes (weighted by the length of road that each stands for and by class), moves the
/// nodes onto it and eases the difference out along the network. Guarantees: nodes of one junction lie on one plane, no
/// steeper than kPlaneSlope; nodes of the network farther than kMaxSpread_m from any stay. Total. O(n log n).
JunctionPlanes fit_junction_planes(const ProfileGraph& graph, std::span<const double> z_m);

}  // namespace citykiln::ground

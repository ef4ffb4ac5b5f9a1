// Junction planes: within a junction, from its nodes to its cuts, the heights of all its roads lie on one plane. A cut
// is the line across a road at which the junction ends.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// The largest slope of a junction plane; the limits of its roads apply, too.
inline constexpr double kPlaneSlope = 0.08;
/// A plane moves the ends of its roads. Along each road this move fades out at 1 m in kSpread m, over at least
/// kMinSpread_m and at most kMaxSpread_m.
inline constexpr double kSpread = 20, kMinSpread_m = 16, kMaxSpread_m = 64;

/// Heights after planes were fitted.
struct JunctionPlanes {
  std::vector<double> z_m;     ///< Heights by node.
  std::vector<Vec2> gradient;  ///< By node the gradient of its junction plane; zero off junctions.
};

/// Fits a plane to the nodes of each junction by least squares (weights: length of road and class), moves the nodes
/// onto it and fades the difference out along the network. Guarantees: nodes of one junction lie on one plane, no
/// steeper than kPlaneSlope; nodes farther than kMaxSpread_m along the network from any junction stay. O(n log n).
/// @param z_m  Heights by node.
JunctionPlanes fit_junction_planes(const ProfileGraph& graph, std::span<const double> z_m);

}  // namespace citykiln::ground

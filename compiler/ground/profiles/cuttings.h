// Finds the cuttings in which lines lead down to tunnels. Retaining walls stand at their sides.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// A line that lies lower below the land than this is in a cutting.
inline constexpr double kLeastCutting_m = 0.25;

/// Returns for each way of the graph its cuttings: the parts on the ground that are connected with the mouth of a
/// tunnel by places more than kLeastCutting_m below the land, up to the next stations.
///
/// @param ground_m  Heights by node of lines on the land.
/// @param z_m       The planned heights by node.
/// O(nodes).
std::vector<std::vector<roads::Cutting>> cuttings_of(const ProfileGraph& graph, std::span<const double> ground_m,
                                                     std::span<const double> z_m);

}  // namespace citykiln::ground

// Nodes that stay where they are, and what they hold in their neighbourhood.
#pragma once

#include <vector>

#include "compiler/ground/profiles/graph_walk.h"

namespace citykiln::ground {

/// A pinned node is felt up to where it leaves this much room.
inline constexpr double kPinRadius_m = 64;

/// By node: the height that the grade limits leave above pinned nodes, infinite where none is near.
std::vector<double> caps_near_pinned(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> z_m);

}  // namespace citykiln::ground

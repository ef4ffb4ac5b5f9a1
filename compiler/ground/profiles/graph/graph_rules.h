// The grade rules of the ways of a profile graph. A leg is a directed edge between neighbouring stations of a way.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/ground/profiles/graph/profile_graph.h"

namespace citykiln::ground {

/// Returns for each node true if a road or rail goes through it. Paths are planned after roads and rails and must not
/// move these nodes.
std::vector<bool> nodes_of_graded(const ProfileGraph& graph);

/// Returns the grade limit of a leg: the largest rise over run.
double limit_of(const ProfileGraph& graph, const Leg& leg);

/// True for ways that may exceed their limit for a clearance: streets and paths, not rails, motorways and runways.
bool may_be_steeper(const ProfileGraph& graph, std::uint32_t way);

}  // namespace citykiln::ground

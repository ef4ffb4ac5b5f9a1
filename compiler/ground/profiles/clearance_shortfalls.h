// Measures clearance shortfalls of stored profiles.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings.h"
#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

/// Returns one shortfall per pair of lines, sorted by ids.
/// @param graph  The graph of all lines (Lines::kAll).
std::vector<ClearanceShortfall> find_shortfalls(const ProfileGraph& graph, const map::Features& features,
                                                const Profiles& profiles, const BelowBridges& below);

}  // namespace citykiln::ground

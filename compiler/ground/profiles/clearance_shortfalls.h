// Measures clearance shortfalls of the profiles as they are stored.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings.h"
#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

/// Returns one shortfall per pair of lines, sorted by the upper line's id; upper lines without an id last.
std::vector<ClearanceShortfall> find_shortfalls(const map::Features& features, const Profiles& profiles,
                                                const BelowBridges& below);

}  // namespace citykiln::ground

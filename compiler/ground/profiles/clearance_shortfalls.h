// What profiles lack of the clearances that they should have, measured on the knots as they are written.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings.h"
#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

/// One for each pair, sorted by the upper's id, those that are none last.
std::vector<ClearanceShortfall> find_shortfalls(const map::Features& features, const Profiles& profiles,
                                                const BelowBridges& below);

}  // namespace citykiln::ground

// What the task of a region is expected to take: a linear model with estimated coefficients, not fitted to runs.
#pragma once

#include <span>

#include "compiler/commands/plan_file.h"

namespace citykiln::commands {

/// Returns time on one core, largest resident memory and bytes of outputs.
///
/// Method: planning takes time and memory for each node of a way in the region's file, and for each vertex of its
/// heightfield; baking for each node within the region and each tile, by the tolerance of each level.
/// @param vertices  Of the heights around the region.
ExpectedCost expected_cost(const PlannedRegion& region, std::size_t vertices, std::span<const double> ladder_m);

}  // namespace citykiln::commands

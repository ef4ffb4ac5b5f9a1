// What the task of a region is expected to take: a linear model of what `plan` knows, fitted to measured tasks.
#pragma once

#include <span>

#include "compiler/commands/plan_file.h"

namespace citykiln::commands {

/// Returns time on one core, largest resident memory and bytes of outputs.
///
/// Method: time for all default levels is a sum over the region's file and heightfield and what lies within the region
/// itself, times the share of its levels. Memory is that of planning and of baking the fullest tile: at the level that
/// needs most, and half of what the other levels need. Bytes are the sum over the levels. A tolerance counts as one
/// that was measured near it. Accuracy: see the source.
ExpectedCost expected_cost(const PlannedRegion& region, double tile_m, std::span<const double> ladder_m);

}  // namespace citykiln::commands

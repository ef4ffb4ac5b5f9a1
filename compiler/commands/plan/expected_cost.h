// Estimates the cost of compiling a region: a linear model of the counts that `plan` makes, fitted to measured tasks.
#pragma once

#include <span>

#include "compiler/commands/plan/plan_file.h"

namespace citykiln::commands {

/// Returns the time on one core, the largest resident memory and the bytes of outputs.
///
/// @param region        Counts of the region's elements and heights.
/// @param tolerances_m  The levels of detail to bake. A tolerance counts as the nearest measured one.
///
/// Method: time is a weighted sum of the counts for all default levels, times the share of these levels that are baked.
/// Memory is the memory of planning plus that of baking the fullest tile: the level that needs most, and half of what
/// the others need. Bytes are the sum over the levels. Accuracy: see the source.
ExpectedCost expected_cost(const PlannedRegion& region, double tile_m, std::span<const double> tolerances_m);

}  // namespace citykiln::commands

// Estimates the cost of compiling a region: a linear model of the counts that `plan` makes, fitted to measured tasks.
#pragma once

#include <span>

#include "compiler/commands/plan/plan_file.h"

namespace citykiln::commands {

/// Returns the time on one core, the largest resident memory and the bytes of outputs.
///
/// Method: the time for all default levels is a weighted sum of counts of the region's file, of its heightfield and of
/// objects within the region, times the share of its levels. Memory is that of planning plus that of baking the fullest
/// tile: that of the level that needs most, and half of what the other levels need. Bytes are the sum over the levels.
/// A tolerance counts as the nearest measured one. Accuracy: see the source.
ExpectedCost expected_cost(const PlannedRegion& region, double tile_m, std::span<const double> tolerances_m);

}  // namespace citykiln::commands

// What the task of a region is expected to take: a linear model of what `plan` knows, fitted to measured tasks.
#pragma once

#include <span>

#include "compiler/commands/plan_file.h"

namespace citykiln::commands {

/// Returns time on one core, largest resident memory and bytes of outputs.
///
/// Method: time is the sum of what planning takes, by the region's file and heightfield, what all levels share, and
/// what each level adds, by what lies within the region itself. Memory is that of planning and of the level that needs
/// most; bytes are the sum over the levels. A tolerance between those that were measured counts as the next finer one.
///
/// Accuracy on 8 places that the model was not fitted to, all default levels: see expected_cost.cpp. Regions of few
/// nodes but much forest are the farthest off, since `plan` does not know how large woods are.
ExpectedCost expected_cost(const PlannedRegion& region, double tile_m, std::span<const double> ladder_m);

}  // namespace citykiln::commands

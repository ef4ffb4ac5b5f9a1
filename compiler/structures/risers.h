// The steps of stairs whose number is tagged, and handrails.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"

namespace citykiln::structures {

/// The lowest and the highest step that step_count=* may lead to: a garden step, and a ladder-like stair.
inline constexpr double kLowestRiser_m = 0.06, kHighestRiser_m = 0.3;

/// Returns the roads with Road::handrails and Road::riser_m. step_count=* is the number of steps of the whole way: the
/// height that it climbs and descends, over the count. A height outside the limits is diagnosed (kStepCountContradicts)
/// and left at 0. O(length of steps).
/// @param tracks  Sorted by id.
std::vector<roads::Road> with_risers(std::vector<roads::Road> roads, std::span<const map::Track> tracks,
                                     const ground::GradedTerrain& ground, Report& report);

}  // namespace citykiln::structures

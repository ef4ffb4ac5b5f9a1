// The riser of stairs, the height of one step, from the tagged number of steps; and their handrails.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"

namespace citykiln::structures {

/// The limits of a riser by step_count=*: a garden step, and a stair that is almost a ladder.
inline constexpr double kLowestRiser_m = 0.06, kHighestRiser_m = 0.3;

/// Returns the roads; stairs get Road::handrails and Road::riser_m from their track. The riser is the height that the
/// whole way climbs and descends, divided by step_count=*. It remains 0 (usual steps) if no count is tagged, or if it
/// is outside the limits, which is diagnosed as kStepCountContradicts. O(length of stairs).
/// @param tracks  Sorted by id.
/// @param ground  Heights along the stairs.
std::vector<roads::Road> with_risers(std::span<const roads::Road> without, std::span<const map::Track> tracks,
                                     const ground::GradedTerrain& ground, Report& report);

}  // namespace citykiln::structures

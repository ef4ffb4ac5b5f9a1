// Guard rails that are assumed along roads above steep drops.
//
//     road edge
//     ________| 0.5 m
//             ‖\         the land kGuardWithin_m beyond the edge is more than kGuardedFall_m lower
//               \____
//
// Source: RPS 2009, 3.3 (restraint systems beside slopes of more than 3 m that are steeper than 1 : 3); the height is
// that of a usual rail.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::things {

/// The fall beyond the edge of a road from which on a guard rail is assumed, and where it is measured.
inline constexpr double kGuardedFall_m = 3, kGuardWithin_m = 6;

/// Returns guard rails along streets on the ground, from service roads to motorways, that have no pavement on the side
/// of the drop. None stand within 3 m of a mapped barrier, within 25 m of a building, on another street, and outside of
/// the extent. A rail is kShortestGuard_m long at least. Ids are of roadside_id(), from 2^15 on; sorted by
/// id, then axis. Roads with rails are counted as Assumption::kRoadsides. O(length of roads).
std::vector<props::Barrier> assumed_guard_rails(const map::FeatureView& features, std::span<const roads::Road> roads,
                                                const ground::GradedTerrain& ground, Report& report);

/// The shortest guard rail, in metres.
inline constexpr double kShortestGuard_m = 16;

}  // namespace citykiln::things

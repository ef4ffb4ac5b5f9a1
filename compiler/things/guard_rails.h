// Guard rails that are assumed along roads above steep drops.
//
//     kerb
//     ________| 0.5 m
//             ‖\         the land kGuardWithin_m beyond the rail is at least kGuardedFall_m lower
//               \____
//
// Source: RPS 2009, 3.3: restraint systems beside slopes that are steeper than 1 : 3 and higher
// than 3 m. The height of a rail, 0.75 m, is the usual one.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::things {

/// The least fall of the land beside a rail, and the distance from the rail within which it is
/// measured, in metres.
inline constexpr double kGuardedFall_m = 3, kGuardWithin_m = 6;

/// Returns guard rails 0.5 m beyond the kerbs of streets, from service roads to motorways, without
/// pavements, cycle tracks or verges on either side.
///
/// A rail stands where the graded land at kGuardWithin_m from it is at least kGuardedFall_m lower,
/// and the terrain before grading has a slope of at least 15 % there. None stand within 3 m of a
/// barrier, within 25 m of a building, within 3 m of another road, or within kGuardWithin_m of the
/// extent's border. Each rail is at least kShortestGuard_m long.
///
/// Ids are those of roadside_id(), from 2^15 on for each road. The order is by id, then axis. Each
/// road with rails is counted as Assumption::kRoadsides, so a way of several roads several times.
/// O(length of roads · things near).
std::vector<props::Barrier> assumed_guard_rails(const map::FeatureView& features, std::span<const roads::Road> roads,
                                                const ground::GradedTerrain& ground, Report& report);

/// The shortest guard rail, in metres.
inline constexpr double kShortestGuard_m = 16;

}  // namespace citykiln::things

// Raises bridges and lowers tunnels until crossings have their clearance.
//
//               ____                 the wanted height, level over the line below, then a round crest and a ramp at
//         .--''      ''--.           three quarters of the limit, over the bridge and its approaches on the ground
//     __.'       o        '.__
//
// The order is: tunnels are lowered between their mouths; then together with their approaches, in cuttings; then
// bridges are raised with their approaches; then tunnels and paths below bridges that could not rise are lowered.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings/crossings.h"

namespace citykiln::ground {

/// Rounds of raising bridges. In stacks of more storeys the topmost bridges may keep a shortfall.
inline constexpr int kLiftRounds = 4;
/// The largest lift of a bridge for one crossing (a clear height, and as much again for a cutting that the heightmap
/// does not show), plus kClearanceOverRail_m for each storey below the bridge.
inline constexpr double kMaxLift_m = 12;
/// The largest lowering of a path on the ground under a bridge. There may be water beside it.
inline constexpr double kMaxPathLowering_m = 2.5;
/// The largest change of a node's height.
inline constexpr double kMaxTotalLift_m = 24;
/// The grade of ramps as a share of the grade limit.
inline constexpr double kRampShare = 0.75;

/// Returns new heights by node.
///
/// @param heights  The terrain: tunnels are lowered until it covers them. Null: lines move for crossings only.
/// @param z_m      Heights by node before this step.
///
/// Guarantees: lines move for crossings only, except tunnels with too little cover; pinned nodes stay; on level ground,
/// lines within their grade limits stay within them; on slopes, ramps may be 3/8 steeper than the limit, so that they
/// end (limit_grades() follows). Cannot fail. Radius of influence: one ramp per storey.
std::vector<double> clear_crossings(const ProfileGraph& graph, std::span<const Crossing> crossings,
                                    const map::Heightfield* heights, std::span<const double> z_m);

}  // namespace citykiln::ground

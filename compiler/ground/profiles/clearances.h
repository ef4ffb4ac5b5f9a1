// Raises bridges and lowers tunnels until crossings have their clearance.
//
//               ____                 the height wanted, level over what is crossed, round, then a ramp at three
//         .--''      ''--.           quarters of the limit: over the bridge and its approaches on the ground
//     __.'       o        '.__
//
// In this order: tunnels are lowered between their mouths; then together with their approaches, in cuttings; then
// bridges are raised with their approaches; then tunnels and paths below bridges that could not rise are lowered.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings.h"

namespace citykiln::ground {

/// Rounds of lifting: stacks of more layers are not solved to the top.
inline constexpr int kLiftRounds = 4;
/// Largest lift for one crossing, plus kClearanceOverRail_m for each storey below it, whatever the heightmap says: a
/// clear height, and as much for a cutting that the heightmap does not show.
inline constexpr double kMaxLift_m = 12;
/// A path on the ground is lowered by at most this under a bridge: there may be water beside it.
inline constexpr double kMaxPathLowering_m = 2.5;
/// Largest distance of any node from where it was.
inline constexpr double kMaxTotalLift_m = 24;
/// Ramps use this share of the grade limit.
inline constexpr double kRampShare = 0.75;

/// Returns new heights by node.
///
/// @param heights  Tunnels are lowered until they are covered by this terrain; nullptr: only crossings move anything.
///
/// Guarantees: nothing moves without a crossing, except tunnels with too little cover; pinned nodes stay; level ground
/// within its limits stays within them; on slopes ramps may be 3/8 steeper than the limit, so that they end
/// (limit_grades() follows). Total. Influence: as many ramps as storeys.
std::vector<double> clear_crossings(const ProfileGraph& graph, std::span<const Crossing> crossings,
                                    const map::Heightfield* heights, std::span<const double> z_m);

}  // namespace citykiln::ground

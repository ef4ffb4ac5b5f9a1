// Bridges rise, tunnels go down, until what crosses clears.
//
//               ____                 the height wanted, level over what is crossed, round, then a ramp at three
//         .--''      ''--.           quarters of the limit: over the bridge and its approaches on the ground
//     __.'       o        '.__
//
// First tunnels go down as far as there is room between their mouths; what they still lack their approaches go down
// with them, in cuttings; then bridges rise, approaches and all; what those still lack tunnels and paths below them go
// down.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings.h"

namespace citykiln::ground {

/// Stacks of more layers than this are not solved to the top.
inline constexpr int kLiftRounds = 4;
/// No crossing lifts or lowers by more than this, and kClearanceOverRail_m for each storey below its own, whatever the
/// heightmap says: a clear height, and as much again for a cutting that the heightmap does not show.
inline constexpr double kMaxLift_m = 12;
/// A path of the ground goes down by no more than this under a bridge: there may be water beside it.
inline constexpr double kMaxPathLowering_m = 2.5;
/// Nothing ends up farther than this from where it was.
inline constexpr double kMaxTotalLift_m = 24;
/// Ramps are built at this share of the grade limit.
inline constexpr double kRampShare = 0.75;
/// Height over which a ramp's crest is round.
inline constexpr double kCrest_m = 1;

/// By node.
///
/// @param heights  What tunnels should be covered by; nullptr: only what crosses moves anything.
///
/// Guarantees: nothing moves without a crossing, but for tunnels under less than their cover; pinned nodes stay; where
/// `z_m` keeps its limits and is level, what comes out keeps them; on slopes ramps may be steeper than the limit
/// by three eighths of it, so that they end (limit_grades() comes after). Total. Reach: as many ramps as storeys.
std::vector<double> clear_crossings(const ProfileGraph& graph, std::span<const Crossing> crossings,
                                    const map::Heightfield* heights, std::span<const double> z_m);

}  // namespace citykiln::ground

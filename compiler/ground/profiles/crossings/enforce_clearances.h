// Restores the clearance of crossings that junction planes and grade limits have reduced. It is the last step of
// planning heights. A junction plane is the plane on which the roads of a junction lie; its nodes move together.
//
//   ___---'o'---___     the way rises by the shortfall of its crossing (o), connected ways as far as their grade
//                       limits require
//
// First bridges rise, tunnels fall, and roads dip under bridges that could not rise; this is done twice. Then roads,
// paths and tunnels rise over tunnels that could not fall.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings/crossings.h"

namespace citykiln::ground {

/// Rounds in each direction. A line that rises below a bridge pushes the bridge up in the next round.
inline constexpr int kEnforceRounds = 6;
/// A ramp falls towards the given heights by at least this share of its limit, so that it terminates on every slope.
inline constexpr double kRampFade = 0.375;
/// The largest change of a node's height.
inline constexpr double kMaxEnforced_m = 24;
/// The largest change of a road on the ground under a bridge or over a tunnel: its terrain is known, and there may be
/// water beside it.
inline constexpr double kMaxGroundMove_m = 2.5;

/// Returns heights by node at which crossings have their clearance.
///
/// @param ground_m  Heights by node before bridges were raised and tunnels lowered. Lines on the ground are lowered
///                  below them by no more than lowering_caps() allows.
/// @param z_m       The heights to change, by node.
///
/// Guarantees: only ways connected with a crossing that has a shortfall move; all nodes of a junction plane move by the
/// same height; ways within 1 + kRampFade times their grade limits stay within these, ways on level ground within the
/// limits; pinned nodes stay. A shortfall that cannot be removed this way remains. Cannot fail. Radius of influence:
/// one ramp of kMaxEnforced_m per round. O(n log n) in nodes that move.
std::vector<double> enforce_clearances(const ProfileGraph& graph, std::span<const Crossing> crossings,
                                       std::span<const double> ground_m, std::span<const double> z_m);

}  // namespace citykiln::ground

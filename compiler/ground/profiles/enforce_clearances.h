// Gives crossings the clearance that junction planes and grade limits have taken back: the last word on heights.
//
//                  o  + what is missing      a way rises by what its crossing lacks, and all that is connected with it
//           ___---' '---___                  by as much as keeps the limits; junction planes move as a whole
//     -----'               '-----
//
// Bridges rise, tunnels fall and roads dip under bridges that could not rise, twice; then roads, paths and tunnels rise
// over tunnels that could not fall.
#pragma once

#include <span>
#include <vector>

#include "compiler/ground/profiles/crossings.h"

namespace citykiln::ground {

/// Rounds in each direction: what rises below a bridge pushes that up in the next.
inline constexpr int kEnforceRounds = 6;
/// A ramp loses at least this share of its limit against the heights given, so it ends on every slope.
inline constexpr double kRampFade = 0.375;
/// No node moves by more than this.
inline constexpr double kMaxEnforced_m = 24;
/// A road on the ground is moved by at most this under a bridge or over a tunnel: its terrain is known, and there may
/// be water beside it.
inline constexpr double kMaxGroundMove_m = 2.5;

/// Returns heights by node at which crossings have their clearance.
///
/// @param ground_m  The heights before anything was cleared: lines on the ground are lowered no farther below them than
///                  lowering_caps() says.
///
/// Guarantees: only ways connected with a crossing that lacks clearance move; nodes of a junction plane move by the
/// same; ways within 1 + kRampFade times their limits stay within that, those on level ground within the limits; pinned
/// nodes stay. What cannot be cleared so keeps its shortfall. Total. Influence: a ramp per round, in which heights fall
/// by kMaxEnforced_m at most. O(n log n) in what moves.
std::vector<double> enforce_clearances(const ProfileGraph& graph, std::span<const Crossing> crossings,
                                       std::span<const double> ground_m, std::span<const double> z_m);

}  // namespace citykiln::ground

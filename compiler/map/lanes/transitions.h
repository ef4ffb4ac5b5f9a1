// Transitions: along a way with placement=transition the axis goes over from its place in the lanes of the way before
// to that in the lanes of the way after.
//
//     ________________                 1. at either end an edge meets that of the neighbour: the left or the right one,
//     ______x_________\________        2. whichever moves the axis least from end to end
//                      x      x        3. in between the axis' distance from the edges changes linearly
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Transitions of this length or longer keep their axis in the middle: their far ends are not known everywhere.
inline constexpr double kLongestTransition_m = 512;

/// Sets the axis of all transitions (Track::is_transition) in their lanes.
///
/// The way before or after is the one that ends at the same node and goes on straightest; one of the same kind goes
/// before others, a transition is none. With one neighbour its placement holds for the whole way; without any, and for
/// long transitions, the axis stays where it is. Bridges and tunnels take the mean of both ends. If the edges are as
/// good on either side, those towards oncoming traffic meet. Depends on no data farther from a way than its ends.
/// O(n log n) in transitions, O(n) in tracks.
void join_transitions(std::vector<Track>& tracks);

}  // namespace citykiln::map

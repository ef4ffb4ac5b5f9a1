// Transitions: along a way with placement=transition, the mapped axis moves sideways within the lanes, from its place
// in the way before to its place in the way after.
//
//     ________________                 1. at either end an edge of the carriageway, the left or the right one, meets
//     ______x_________\________           that of the neighbour
//                      x      x        2. edges are chosen so that the axis moves least from end to end
//                                      3. in between the axis' distance from the edges changes linearly
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Transitions of this length or longer keep their axis in the middle, since data of both ends may not be at hand.
inline constexpr double kLongestTransition_m = 512;

/// Sets the place of the axis in the lanes (axis_offset_m and axis_drift) of all transitions (Track::is_transition).
///
/// The neighbour at an end is the road that ends at the same node and goes on straightest, turning by less than about
/// 45°. Roads of the same kind are preferred; a transition is no neighbour. With one neighbour, its placement holds for
/// the whole way. The axis stays where it is without neighbours, and in long or closed transitions. Bridges and tunnels
/// take the mean of both ends. On a tie, the edges towards oncoming traffic meet. The result depends on data at the
/// ends of a way only. O(n log n) in transitions, O(n) in tracks.
void join_transitions(std::vector<Track>& tracks);

}  // namespace citykiln::map

// Widths that no tag states give way to what is mapped beside a road.
//
//      o    o     o            a tree, wall or hydrant beside a road says how far its kerb goes at most
//    ________________________  1. the carriageway moves sideways, unless placement=* says where it lies
//     - - - - - - - - - - - -  2. parking, shoulders and buffers narrow, then lanes (lane_rules.inc: NARROWEST)
//    ________________________
//
// Buildings limit the width in places (width_limits/); what is mapped otherwise limits it along the whole way.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::roads {

/// Ways longer than this keep their widths, so that nothing farther away than this changes a road.
inline constexpr double kLongestFitted_m = 512;

/// Returns the tracks with the sections of streets on the ground fitted between trees, hydrants, posts, masts, rows of
/// trees, walls, fences and hedges.
///
/// A section is the same along the way, and changes only where the width of its carriageway is not tagged. Trees keep
/// kTreeFromKerb_m from the kerb, other things kThingFromKerb_m. What stands so near the axis that the narrowest lanes
/// do not leave room for it says nothing, nor do walls that cross the way: such things are in the road by the map.
///
/// Order of features does not matter. Total. O(n log n).
std::vector<map::Track> fit_assumed_widths(const map::Features& features);

/// Half a trunk and a kerb; a lamp post or a wall and a kerb.
inline constexpr double kTreeFromKerb_m = 0.5, kThingFromKerb_m = 0.25;

}  // namespace citykiln::roads

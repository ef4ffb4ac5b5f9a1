// Fits assumed widths of carriageways (those without width tags) between objects that are mapped beside a road.
//
//      o    o     o            a tree, wall or hydrant beside a road limits the distance of its kerb from the axis
//    ________________________  1. the carriageway moves sideways, unless placement=* is tagged
//     - - - - - - - - - - - -  2. parking, shoulders and buffers narrow, then lanes (lane_rules.inc: NARROWEST)
//    ________________________
//
// Buildings limit the width locally (width_limits/). Other objects limit it along the whole way.
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::assume {

/// Longer ways keep their widths, so that no object farther away than this changes a road.
inline constexpr double kLongestFitted_m = 512;

/// Returns the tracks. The cross-sections of streets on the ground are fitted between trees, hydrants, posts, masts,
/// rows of trees, walls, fences and hedges.
///
/// A section does not vary along the way, and changes only if the width of its carriageway is not tagged. The kerb
/// keeps kTreeFromKerb_m from trees and kThingFromKerb_m from other objects. Objects for which even the narrowest lanes
/// leave no room are ignored, and so are walls that cross the way, since the map puts them inside the road.
///
/// The order of features does not matter. O(n log n).
std::vector<map::Track> fit_assumed_widths(const map::FeatureView& features);

/// Distances of objects from the kerb: half a trunk and a kerb stone for trees; a lamp post or a wall and a kerb stone
/// for others.
inline constexpr double kTreeFromKerb_m = 0.5, kThingFromKerb_m = 0.25;

}  // namespace citykiln::assume

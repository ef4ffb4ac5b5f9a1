// Traffic signals that are mapped on a node of a junction: one for each arm on which traffic comes in.
//
//             |     |
//             |     s       o  the mapped node
//     --------+     +----   s  signals: where the junction begins, on the side of the traffic, facing it
//     <---       o   <---
//     --->           --->
//     ----s---+     +----
//             |     |
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"

namespace citykiln::things {

/// A mapped signal this far from the node of a junction, on an arm, belongs to the arm.
inline constexpr double kSignalBefore_m = 30;
/// The size of a signal for two lanes or more: a pole in the middle of its box, and an arm that reaches over the lanes,
/// at most kMostLanes.
inline constexpr double kTallSignal_m = 6, kReachPerLane_m = 3;
inline constexpr int kMostLanes = 4;

/// Returns the things of one kind with those on the nodes of junctions replaced by one for each arm of the junction on
/// which motor traffic comes in. An arm that lies inside the junction has none, nor has one with a thing of the kind of
/// its own. A new thing has the id of the mapped one nearest to it, with the parts 1, 2, 3 …, and lies on the axis
/// where the junction begins. Its capacity is the number of lanes on which traffic comes in, its text is "left" for
/// left-hand traffic. O(n log n), plus
/// arms of junctions with such a thing times things.
std::vector<map::ThingFeature> with_one_for_each_arm(std::span<const map::ThingFeature> things,
                                                     std::span<const roads::Road> roads,
                                                     std::span<const roads::Junction> junctions);

}  // namespace citykiln::things

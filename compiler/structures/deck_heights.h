// How high a deck lies at each station: on the line between its anchors, lifted where there is room to rise.
//
//                 ______________      6 % up to the clearance of its layer
//            ___/               \___
//     ─ ─ ─●─ ─ ─ ─ ─ ─ ─ ─ ─ ─ ─ ─ ─●─ ─    level for the first metres, so that short bridges stay flat
#pragma once

#include <vector>

#include "compiler/structures/deck_graph.h"

namespace citykiln::structures {

/// Steepest rise over the line between the anchors: what ramps of roads are built with.
inline constexpr double kBridgeGrade = 0.06;

/// A deck stays on its line for this long from an anchor; a bridge of twice this is a culvert, or as flat as one.
inline constexpr double kLevelEnd_m = 8;

/// Metres, parallel to the stations, snapped.
///
/// Guarantees: anchored stations lie at their ground's height; a chain between two anchors lies on or above the
/// straight line between them, by no more than kBridgeGrade times the distance to the nearer one, nor than its
/// clearance. Where more than two anchors are near, each counts by the inverse of its distance; anchors behind other
/// anchors do not count. A station that reaches no anchor lies on the ground. O(s log s) for each anchor, s the
/// stations that it reaches.
std::vector<double> deck_heights(const DeckGraph& graph);

}  // namespace citykiln::structures

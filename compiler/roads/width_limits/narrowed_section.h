// The cross-section of a road within its width limits.
//
//       outer edge _____                _____      1. the pavement narrows down to kMinPavement_m
//             kerb ___  \______________/  ___      2. then the carriageway down to kMinCarriageway_m
//                  ...\__/############\__/...      3. then the rest of the pavement
//           middle - - - - - - - - - - - - - -     4. beyond that nothing narrows: the building stands in the road
//
// The two sides are independent. No edge turns by more than kTaper, because the limit does not, and the position of
// every edge is a continuous function of the limit.
#pragma once

#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The largest slope of an edge, in metres sideways per metre along the road: smooth to drive at walking pace, and
/// without visible steps.
inline constexpr double kTaper = 0.125;

/// The width that a carriageway for cars keeps: a vehicle of 2.5 m, the widest without a permit.
inline constexpr double kMinCarriageway_m = 2.5;

/// The width that a path keeps: one person with a pram.
inline constexpr double kMinPath_m = 1;

using map::is_soft;
using map::kMinPavement_m;

/// The minimum distance from the carriageway's middle to either kerb.
double min_half_width_m(const Road& road);

/// The maximum distances of the outer edges from the axis; infinite without a limit.
struct MaxOffsets {
  double left_m, right_m;  ///< Left and right of the axis, metres.
};

/// Returns the limits at a distance along the whole way (distances_along()). They change by at most kTaper. O(log n) in
/// limits.
MaxOffsets max_offsets_at(const Road& road, double along_m);

/// Distances of the edges from the axis. The road covers -right_m to left_m; its carriageway lies between the kerbs.
struct RoadEdges {
  double left_m, kerb_left_m, kerb_right_m, right_m;
};

/// Returns the edges within the width limits. O(log n) in limits, O(n) in lanes.
RoadEdges road_edges_at(const Road& road, double along_m);

/// Returns the distances along the whole way at which an edge bends relative to the axis, the edge of the paved part
/// included. Sorted. Empty without limits. O(n log n) in limits.
std::vector<double> bends_of_edges(const Road& road);

/// A narrowed cross-section.
struct NarrowedSection {
  double left_m = 0;             ///< Distance from the axis to the outer left edge.
  std::vector<double> widths_m;  ///< Widths of the section's lanes, left to right; 0 if no room is left for a lane.
};

/// Returns the width of each lane. Outside a kerb, buffers and verges narrow first, then the outermost lane. Between
/// the kerbs, the outermost parking, shoulders and buffers narrow first, then all other lanes in proportion. Widths add
/// up to road_edges_at() and are continuous along the road.
NarrowedSection narrowed_section_at(const Road& road, double along_m);

/// The edges of a road's lanes at full width (at the way's first point where the axis drifts), and their positions
/// within the width limits. Offsets from the axis, to the left positive.
struct LaneEdges {
  std::vector<double> whole_m, moved_m;  ///< From the left edge to the right one: one more than lanes.

  /// Returns where the width limits move a point at an offset of the full road. It keeps its share of its lane's width.
  double moved(double offset_m) const;
};
LaneEdges lane_edges_at(const Road& road, double along_m);

}  // namespace citykiln::roads

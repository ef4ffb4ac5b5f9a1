// What of a road gives way where buildings stand in it.
//
//       outer edge _____                _____      1. its pavement, down to kMinPavement_m
//             kerb ___  \______________/  ___      2. then its carriageway, down to kMinCarriageway_m
//                  ...\__/############\__/...      3. then what is left of the pavement
//           middle - - - - - - - - - - - - - -     4. then nothing: the building stands in the road
//
// Each side gives way for itself. No edge turns away from the axis by more than kTaper: the limit does not, and what is
// kept of it is continuous.
#pragma once

#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// An edge moves sideways at most so much a metre along the axis: a car follows it at walking pace without turning the
/// wheel back and forth, and one does not see a step.
inline constexpr double kTaper = 0.125;

/// A pavement is kept this wide while the carriageway can give way: room for a kerb stone and a foot beside it.
inline constexpr double kMinPavement_m = 0.5;

/// A carriageway that is driven on keeps this: the widest vehicle that is allowed without a permit, 2.5 m.
inline constexpr double kMinCarriageway_m = 2.5;

/// One that is walked or cycled on keeps this: one person with a pram.
inline constexpr double kMinPath_m = 1;

/// From the carriageway's middle to either kerb, where the road is as narrow as it may be.
double min_half_width_m(const Road& road);

/// From the axis to where the road's outer edges may be at most. Infinite where no building is near.
struct MaxOffsets {
  double left_m, right_m;
};

/// @param along_m  From the beginning of the whole way, as distances_along() says.
///
/// Never changes by more than kTaper a metre. O(log n) in pinches.
MaxOffsets max_offsets_at(const Road& road, double along_m);

/// From the axis, seen along it; what is left of the road is from -right_m to left_m, and its carriageway between the
/// kerbs.
struct RoadEdges {
  double left_m, kerb_left_m, kerb_right_m, right_m;
};

/// The road's edges, narrowed. O(log n) in pinches, O(n) in lanes.
RoadEdges road_edges_at(const Road& road, double along_m);

/// Distances along the whole way between which all edges, that of the paved part too, run straight beside their axis,
/// sorted. None where no building
/// is near. O(n log n) in pinches.
std::vector<double> bends_of_edges(const Road& road);

/// A cross-section that has given way.
struct NarrowedSection {
  double left_m = 0;             ///< From the axis to the outer left edge.
  std::vector<double> widths_m;  ///< Of the section's lanes, left to right; 0: gone.
};

/// What becomes of each lane. Beyond a kerb buffers and verges give way first, then the outermost lane; between the
/// kerbs first the outermost parking, shoulders and buffers, then all others alike. The widths add up to what
/// road_edges_at says, and none jumps along the road.
NarrowedSection narrowed_section_at(const Road& road, double along_m);

/// Where the edges of lanes lie on the whole road, and where they are moved to, from the axis, to the left positive.
struct LaneEdges {
  std::vector<double> whole_m, moved_m;  ///< From the left edge to the right one: one more than lanes.

  /// Where a place between the whole road's edges is moved to: with its lane, in its share.
  double moved(double offset_m) const;
};
LaneEdges lane_edges_at(const Road& road, double along_m);

}  // namespace citykiln::roads

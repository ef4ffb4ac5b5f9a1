// Rows of parking bays: how bays lie in a parking lane. Paint and parked cars use the same rows.
//
//     along            slanted, 60 degrees         square
//     |      |      |    /    /    /    /    |   |   |   |   |    kerb
//     |      |      |   /    /    /    /     |   |   |   |   |    depth_m
//       6 m               3 m                  2.4 m
#pragma once

#include "compiler/map/cross_section.h"

namespace citykiln::roads {

/// A row of parking bays.
struct BayRow {
  double step_m = 0;   ///< The distance of the lines between bays, along the road; divides kLayoutLength_m.
  double depth_m = 0;  ///< The width of the row across the road.
  /// How much farther along the way a line is at the row's right edge than at its left one; 0 unless bays are slanted.
  /// A line is at a multiple of step_m in the middle of the row.
  double rise_m = 0;
  bool is_along = false;  ///< True if cars stand along the road, false if they stand along the lines.
};

/// Rows from this width on are slanted, and from the second on square; narrower ones have cars along the road. A car of
/// 4.2 by 1.9 m takes 4 m at 60 degrees, if 0.3 m of it reach over the edges.
inline constexpr double kSlantedRow_m = 4, kSquareRow_m = 4.75;

/// Returns the row of bays of a parking lane, at its full width. Kerb lengths of a car after RAST 06: 5.5, 2.9 and
/// 2.4 m, rounded up to divide kLayoutLength_m. Slanted bays lean in the direction of the traffic beside them.
BayRow bays_of(const map::Lane& lane, map::DrivingSide side);

/// The bays nearest to a junction are not painted, up to this distance from its stop line (StVO, paragraph 12: no
/// parking within 5 m of a junction).
inline constexpr double kLastBayEnds_m = 6;

}  // namespace citykiln::roads

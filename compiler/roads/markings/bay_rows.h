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
  double step_m = 0;   ///< The distance between lines, along the road; divides kLayoutLength_m.
  double depth_m = 0;  ///< The width of the row across the road.
  /// The distance along the road from the left end of a line to its right end; 0 unless bays are slanted. The middle of
  /// each line is at a multiple of step_m.
  double rise_m = 0;
  bool is_along = false;  ///< True if cars stand along the road, false if they stand along the lines.
};

/// Rows of kSlantedRow_m or more are slanted, of kSquareRow_m or more square; in narrower rows cars stand along the
/// road. At 60 degrees a car of 4.2 by 1.9 m takes 4.6 m, of which 0.3 m may reach over each edge.
inline constexpr double kSlantedRow_m = 4, kSquareRow_m = 4.75;

/// Returns the row of bays of a parking lane at its full width. Lengths of kerb per car: RASt 06 has 5.5, 2.9 and 2.4
/// m, rounded up here to divide kLayoutLength_m. Slanted bays lean as traffic on the right (or left) side of a two-way
/// street drives; beside the opposite kerb of a one-way street they lean against it.
BayRow bays_of(const map::Lane& lane, map::DrivingSide side);

/// Bays within this distance of a stop line are not painted, in metres: StVO, paragraph 12, forbids parking within 5 m
/// of a junction; 6 m is half of kLayoutLength_m, which markings_parking.cpp relies on.
inline constexpr double kLastBayEnds_m = 6;

}  // namespace citykiln::roads

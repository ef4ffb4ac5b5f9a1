// Lane changes: where one street continues another with different lanes, the lane lines of one lead to those of the
// other.
//
//     ______________......-----------   1. lanes that continue on the other side are matched, each with one of the
//     - - - - - - - - - - - - - - - -      same direction
//     ____________                      2. between the junction's cut and the node, the side with fewer lanes (of equal
//                 ```````- - - - - -       numbers, the narrower one) leads its lines to those of the other
//                        ------------   3. lanes that begin or end have lines only on the side with more lanes
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// The part of a road, from a node to the cut of its junction, along which its lanes lead to those of the next road.
struct LaneChange {
  double node_m = 0, cut_m = 0;  ///< Distances from the first point of the road's axis, metres along it.
  /// The edges of all the road's lanes at the node, left to right as seen along the road: distances from the axis in
  /// metres, positive to the left. One more than there are lanes.
  std::vector<double> offsets_m;
  /// Returns how far edges have moved from their usual place (0) to offsets_m (1) at a distance along the way: 0 at the
  /// cut, 1 at the node, linear in between; 0 outside the change.
  double share_at(double along_m) const;
};

/// True if a junction only joins two streets that continue each other, so that the roads' own pieces cover it. An arm
/// is a road that leaves the junction.
/// @param arms  The entry of arms_of() for this junction.
bool is_lane_change(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

/// Returns the lane changes of each road, at most one at each end. At the node the carriageways of both roads have the
/// same outer edges, and lines between matched lanes meet. O(n log n) in vertices, O(lanes²) for each change.
std::vector<std::vector<LaneChange>> lane_changes_of(std::span<const Road> roads, std::span<const Junction> junctions);

}  // namespace citykiln::roads

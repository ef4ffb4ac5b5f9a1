// Lane changes: where a street goes on with other lanes, the lanes of either side lead to each other.
//
//     ______________......-----------   1. lanes of both sides that go on are matched, those of one direction with
//     - - - - - - - - - - - - - - - -      each other
//     ____________                      2. along the taper the side with fewer lanes leads its lines to those of
//                 ```````- - - - - - -     the other
//                        ------------   3. lanes that are added or end have their lines only on the other side
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// The part of a road, from a node to the cut of its junction, along which its lanes lead to those of the next road.
struct LaneChange {
  double node_m = 0, cut_m = 0;   ///< Distances along the way.
  std::vector<double> offsets_m;  ///< The edges of all its lanes at the node, left to right: offsets from the axis, to
                                  ///< the left positive.
  /// The share of the way to offsets_m that edges have gone at a distance along the way: 0 at the cut and beyond the
  /// change, 1 at the node.
  double share_at(double along_m) const;
};

/// True if two streets continue each other at this junction with other lanes, so that the pieces of both roads cover
/// it. An arm is a road that leaves the junction.
/// @param arms  The entry of arms_of() for this junction.
bool is_lane_change(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

/// Returns the changes of each road, at most one at each end. At the node the carriageways of both roads have the same
/// edges, and matched lanes of equal number have the same lines. O(n log n) in vertices, O(lanes²) a change.
std::vector<std::vector<LaneChange>> lane_changes_of(std::span<const Road> roads, std::span<const Junction> junctions);

}  // namespace citykiln::roads

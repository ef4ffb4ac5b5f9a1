// Reads the moving lanes of a road from its tags: all lanes except the roadsides (parking, pavements and similar). A
// flow is the traffic in one direction of the way.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_counts.h"

namespace citykiln::map {

/// The moving lanes. The lists of `flows` run from the middle of the road outwards. A width of 0 is set by
/// share_widths().
struct MovingLanes {
  PerFlow<std::vector<Lane>> flows;
  std::vector<Lane> middle;
  PerFlow<bool> has_cycle_lane;  ///< True if bicycle:lanes lists a cycle lane; cycleway=lane then adds no second one.
  double counted = 0;  ///< The number of lanes from which default widths follow (LaneCounts::counted), plus bus lanes
                       ///< that lanes=* does not count.
  bool is_tagged = false;  ///< LaneCounts::is_tagged.

  /// Returns all lanes: the middle ones, then each flow outwards.
  std::vector<Lane*> all();
};

/// Returns the lanes. Their kinds follow from bicycle:lanes, bus:lanes and psv:lanes; else from lanes:bus, lanes:psv
/// and busway, which make the outer lanes bus lanes and add a lane if no driving lane would remain.
MovingLanes moving_lanes_of(const LaneTags& tags, const LaneClass& lane_class);

}  // namespace citykiln::map

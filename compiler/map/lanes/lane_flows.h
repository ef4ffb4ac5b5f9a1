// Reads the moving lanes of a road from its tags: all lanes except the roadsides (parking, pavements and similar). A
// flow is the traffic in one direction of the way.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_counts.h"

namespace citykiln::map {

/// The moving lanes. The lists of `flows` run from the middle of the road outwards. Lanes without a tagged width have
/// width 0; share_widths() decides it.
struct MovingLanes {
  PerFlow<std::vector<Lane>> flows;
  std::vector<Lane> middle;  ///< Lanes of no direction, between the flows, such as a lane for turns from both sides.
  PerFlow<bool> has_cycle_lane;  ///< True if bicycle:lanes lists a cycle lane; cycleway=lane then adds no second one.
  /// The number of lanes by which a default width is divided: that of lanes=*, plus bus lanes that lanes=* leaves
  /// out; 1.5 for lanes=1.5.
  double counted = 0;
  bool is_tagged = false;  ///< True if tags say the number of lanes; else it is the default of the road's class.

  /// Returns all lanes: the middle ones, then each flow outwards. Valid until a list changes.
  std::vector<Lane*> all();
};

/// Returns the lanes. Their kinds follow from bicycle:lanes, bus:lanes and psv:lanes; else from lanes:bus, lanes:psv
/// and busway, which make the outer lanes bus lanes and add a lane if no driving lane would remain.
MovingLanes moving_lanes_of(const LaneTags& tags, const LaneClass& lane_class);

}  // namespace citykiln::map

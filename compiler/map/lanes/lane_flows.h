// The moving lanes of a road: all lanes except its roadsides.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_counts.h"

namespace citykiln::map {

/// Lanes of each flow from the middle of the road outwards. share_widths() sets widths that are 0.
struct MovingLanes {
  PerFlow<std::vector<Lane>> flows;
  std::vector<Lane> middle;
  PerFlow<bool> has_cycle_lane;  ///< True if bicycle:lanes names one: cycleway=lane does not add another.
  double counted = 0;            ///< LaneCounts::counted, plus bus lanes that lanes=* does not count.
  bool is_tagged = false;        ///< LaneCounts::is_tagged.

  /// Returns all lanes: the middle ones, then each flow outwards.
  std::vector<Lane*> all();
};

/// Returns the lanes. Their kinds follow from bicycle:lanes, bus:lanes and psv:lanes; else from lanes:bus, lanes:psv
/// and busway, which make the outer lanes bus lanes and add a lane if no driving lane would remain.
MovingLanes moving_lanes_of(const LaneTags& tags, const LaneClass& lane_class);

}  // namespace citykiln::map

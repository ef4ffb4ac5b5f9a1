// The lanes of a road on which something moves, without its roadsides.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_counts.h"

namespace citykiln::map {

/// Lanes from the middle outwards; in the middle, in any order. A width_m of 0 is for lane_widths to fill.
struct MovingLanes {
  PerFlow<std::vector<Lane>> flows;
  std::vector<Lane> middle;
  PerFlow<bool> has_cycle_lane;  ///< bicycle:lanes told it: cycleway=lane does not add another.
  double counted = 0;            ///< As in LaneCounts, with bus lanes added that lanes=* did not count.
  bool is_tagged = false;        ///< As in LaneCounts.

  /// All of them: the middle, then each flow outwards.
  std::vector<Lane*> all();
};

/// Kinds by bicycle:lanes, bus:lanes, psv:lanes; else by lanes:bus, lanes:psv and busway, which turn the outer lanes
/// into bus lanes and add one where no lane to drive on would remain.
MovingLanes moving_lanes_of(const LaneTags& tags, const LaneClass& lane_class);

}  // namespace citykiln::map

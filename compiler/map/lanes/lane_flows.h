// The moving lanes of a road: all lanes except its roadsides.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_counts.h"

namespace citykiln::map {

/// Lanes from the middle outwards; those in the middle in any order. A width_m of 0 is set by share_widths().
struct MovingLanes {
  PerFlow<std::vector<Lane>> flows;
  std::vector<Lane> middle;
  PerFlow<bool> has_cycle_lane;  ///< By bicycle:lanes: cycleway=lane does not add another.
  double counted = 0;            ///< As in LaneCounts, plus bus lanes that lanes=* does not count.
  bool is_tagged = false;        ///< As in LaneCounts.

  /// All lanes: the middle, then each flow outwards.
  std::vector<Lane*> all();
};

/// Returns the lanes with kinds by bicycle:lanes, bus:lanes and psv:lanes; else by lanes:bus, lanes:psv and busway,
/// which make the outer lanes bus lanes and add one where no driving lane would remain.
MovingLanes moving_lanes_of(const LaneTags& tags, const LaneClass& lane_class);

}  // namespace citykiln::map

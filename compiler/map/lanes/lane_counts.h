// Counts the lanes of a road, by direction of traffic (flow).
#pragma once

#include "compiler/map/lanes/lane_class.h"
#include "compiler/map/lanes/lane_lists.h"
#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// The lanes for cars, buses and turning, without cycle lanes.
struct LaneCounts {
  PerFlow<int> flows;
  int in_middle = 0;               ///< Lanes that both flows share.
  bool is_middle_to_turn = false;  ///< True if the middle lanes are for turning, else they are for driving.
  bool is_contraflow_bus = false;  ///< True if the opposite flow of a one-way road is a bus lane.
  double counted = 0;              ///< The number from which default widths follow: 1.5 for lanes=1.5.
  bool is_tagged = false;          ///< True if from tags, else the class's default.

  int total() const { return flows[Flow::kForward] + flows[Flow::kBackward] + in_middle; }
};

/// Returns the counts by lanes, lanes:forward, lanes:backward, lanes:both_ways, centre_turn_lane and the lengths of the
/// …:lanes lists, with the precedence of lanes.h. There is at least one lane, at most kMaxLanes per flow and
/// kMaxLanesOfRoad in all. Contradictions are diagnosed kBadTagValue.
/// @param lists  The …:lanes lists of each flow.
LaneCounts lane_counts_of(const LaneTags& tags, const LaneClass& lane_class, const PerFlow<LaneList>& lists);

}  // namespace citykiln::map

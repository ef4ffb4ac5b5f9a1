// The number of lanes of each flow of a road.
#pragma once

#include "compiler/map/lanes/lane_class.h"
#include "compiler/map/lanes/lane_lists.h"
#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// The lanes for cars, buses and turning, without cycle lanes.
struct LaneCounts {
  PerFlow<int> flows;
  int in_middle = 0;               ///< Shared by both flows.
  bool is_middle_to_turn = false;  ///< For turning, else for driving.
  bool is_contraflow_bus = false;  ///< The opposite flow of a one-way road is a bus lane.
  double counted = 0;              ///< The count by which the class computes its width: lanes=1.5 is one and a half.
  bool is_tagged = false;          ///< By tags; otherwise the class's default.

  int total() const { return flows[Flow::kForward] + flows[Flow::kBackward] + in_middle; }
};

/// Returns the counts by lanes, lanes:forward, lanes:backward, lanes:both_ways, centre_turn_lane and the lengths of the
/// lists, in the order of precedence of lanes.h. At least one lane, at most kMaxLanes a flow and kMaxLanesOfRoad in
/// all. Diagnosed: kBadTagValue for contradictions.
LaneCounts lane_counts_of(const LaneTags& tags, const LaneClass& lane_class, const PerFlow<LaneList>& lists);

}  // namespace citykiln::map

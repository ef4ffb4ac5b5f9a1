// How many lanes each flow of a road has.
#pragma once

#include "compiler/map/lanes/lane_class.h"
#include "compiler/map/lanes/lane_lists.h"
#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// The lanes of a road that cars, buses and turning cars use; none for cycling.
struct LaneCounts {
  PerFlow<int> flows;
  int in_middle = 0;               ///< Shared by both flows.
  bool is_middle_to_turn = false;  ///< What the middle is for: turning, else driving.
  bool is_contraflow_bus = false;  ///< The other flow of a one-way road is a bus lane.
  double counted = 0;              ///< Lanes by which the class counts its width: lanes=1.5 is one lane and a half.
  bool is_tagged = false;          ///< Some tag told how many; otherwise it is the class's number.

  int total() const { return flows[Flow::kForward] + flows[Flow::kBackward] + in_middle; }
};

/// By the tags lanes, lanes:forward, lanes:backward, lanes:both_ways, centre_turn_lane and the lengths of the lists, in
/// the order lanes.h says. At least one lane, at most kMaxLanes a flow and kMaxLanesOfRoad in all; contradictions are
/// diagnosed kBadTagValue.
LaneCounts lane_counts_of(const LaneTags& tags, const LaneClass& lane_class, const PerFlow<LaneList>& lists);

}  // namespace citykiln::map

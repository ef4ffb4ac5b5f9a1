// Reads the …:lanes lists of one flow (the traffic in one direction): turn:lanes, bus:lanes, psv:lanes, bicycle:lanes,
// width:lanes.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// The entries of all lists for one lane. width_m 0: not tagged.
struct ListedLane {
  LaneKind kind = LaneKind::kDriving;  ///< kDriving, kBus or kCycle.
  double width_m = 0;
  std::uint16_t turns = 0;
};

/// The combined lists of one flow, from the middle of the road outwards. Diagnosed as kBadTagValue and ignored: lists
/// whose length differs from the first of bicycle:lanes, bus:lanes, psv:lanes, turn:lanes, width:lanes; lists of more
/// than kMaxLanes, or with more than two cycle lanes.
struct LaneList {
  std::vector<ListedLane> lanes;
  int cycle_count() const;
  int driven_count() const { return static_cast<int>(lanes.size()) - cycle_count(); }
};

/// Returns the lists of a flow; empty if none is tagged.
LaneList listed_lanes(const LaneTags& tags, Flow flow);

/// Returns the LaneTurn bits of one lane's turns ("left;through").
/// @param is_known  Set to false for an unknown word, which sets no bit, and for a text with several lanes
///                  ("left|right"), which gives no bits at all.
std::uint16_t turns_of(std::string_view text, bool& is_known);

}  // namespace citykiln::map

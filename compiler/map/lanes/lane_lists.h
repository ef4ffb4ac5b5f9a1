// The …:lanes lists of one flow: turn:lanes, bus:lanes, psv:lanes, bicycle:lanes, width:lanes.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// One entry of the lists. width_m 0: not told.
struct ListedLane {
  LaneKind kind = LaneKind::kDriving;  ///< kDriving, kBus or kCycle.
  double width_m = 0;
  std::uint16_t turns = 0;
};

/// What the lists of one flow say together, from the middle of the road outwards. Lists that differ in length from the
/// first of bicycle:lanes, bus:lanes, psv:lanes, turn:lanes, width:lanes are diagnosed kBadTagValue and left out, as
/// are lists of more than kMaxLanes or of more than two cycle lanes.
struct LaneList {
  std::vector<ListedLane> lanes;
  int cycle_count() const;
  int driven_count() const { return static_cast<int>(lanes.size()) - cycle_count(); }
};

LaneList listed_lanes(const LaneTags& tags, Flow flow);

/// The bits of one lane's turns, "left;through". Words nobody knows set no bit, more lanes than
/// one set none at all; `is_known` then becomes false.
std::uint16_t turns_of(std::string_view text, bool& is_known);

}  // namespace citykiln::map

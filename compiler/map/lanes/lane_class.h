// The lane class of a way: its row of track_rules.inc in terms of lanes.
#pragma once

#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

struct LaneClass {
  LaneKind kind = LaneKind::kFoot;
  double width_m = 2;         ///< Of one lane; of the whole where lanes are not counted.
  int lanes = 0;              ///< The default number; 0: lanes are not counted.
  bool is_motorway = false;   ///< Keeps its number of lanes when one-way.
  bool is_road = false;       ///< Has a carriageway, roadsides and pavements by tags.
  bool is_both_ways = false;  ///< Used both ways regardless of oneway=*: foot, rails, runways.

  /// Returns the total width where untagged, by the lanes counted in tags (1.5 is possible).
  double width_m_of(double counted) const;
};

LaneClass lane_class_of(const LaneTags& tags);

/// Widths of lane_rules.inc, metres.
#define LANE_WIDTH(name, metres) inline constexpr double name = metres;
#include "compiler/map/lanes/lane_rules.inc"
#undef LANE_WIDTH

}  // namespace citykiln::map

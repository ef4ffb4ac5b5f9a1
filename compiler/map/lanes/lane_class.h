// The row of track_rules.inc a way belongs to, as its cross-section sees it.
#pragma once

#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

struct LaneClass {
  LaneKind kind = LaneKind::kFoot;
  double width_m = 2;         ///< Of one lane; of the whole where it is not counted by lanes.
  int lanes = 0;              ///< Where none are tagged; 0: not counted by lanes.
  bool is_motorway = false;   ///< Keeps its lanes though it is one-way.
  bool is_road = false;       ///< Has a carriageway whose lanes, roadsides and pavements tags may tell.
  bool is_both_ways = false;  ///< Whatever oneway=* says: feet, rails, runways.

  /// The width of the whole where no tag tells, by the lanes counted in tags (1.5 is possible).
  double width_m_of(double counted) const;
};

LaneClass lane_class_of(const LaneTags& tags);

/// Widths of lane_rules.inc, metres.
#define LANE_WIDTH(name, metres) inline constexpr double name = metres;
#include "compiler/map/lanes/lane_rules.inc"
#undef LANE_WIDTH

}  // namespace citykiln::map

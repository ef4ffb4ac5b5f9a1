// The lane class of a way: the default kind, width and number of its lanes.
#pragma once

#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

struct LaneClass {
  LaneKind kind = LaneKind::kFoot;
  double width_m = 2;         ///< Width of one lane, or of the whole way if lanes are not counted.
  int lanes = 0;              ///< The default number; 0: lanes are not counted.
  bool is_motorway = false;   ///< True if one-way roads have the default number of lanes, too.
  bool is_road = false;       ///< True if tags can give it roadsides and pavements.
  bool is_both_ways = false;  ///< True if used both ways regardless of oneway=*: foot, rails, runways.

  /// Returns the default total width of `counted` lanes; 1.5 lanes are possible.
  double width_m_of(double counted) const;
};

/// Returns the lane class of a way.
LaneClass lane_class_of(const LaneTags& tags);

/// Widths of lane_rules.inc, metres.
#define LANE_WIDTH(name, metres) inline constexpr double name = metres;
#include "compiler/map/lanes/lane_rules.inc"
#undef LANE_WIDTH

}  // namespace citykiln::map

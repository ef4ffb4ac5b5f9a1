// How broad lines are and how they are broken, by the road they are on.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

struct LineMeasures {
  double narrow_m, broad_m;  ///< Between lanes; where the line means more: bus and cycle lanes, lanes that leave.
  DashPattern broken, broad_broken;
  bool has_lane_lines;  ///< Also between opposite directions.
  bool has_edge_lines;
};

LineMeasures measures_of(const MarkingLayout& layout);

/// Residential, service and pedestrian streets.
bool is_quiet(const MarkingLayout& layout);
/// Whether paint would hold: not on gravel, earth and ballast.
bool takes_paint(const MarkingLayout& layout);

/// Of a lane, what drivers who come to the junction at the pattern's end use: all of it, or of a wide lane of both
/// directions the half they drive in. Empty (low >= high) where none come.
struct LaneSpan {
  double low_m, high_m;
};
LaneSpan arriving_span(const MarkingLayout& layout, std::size_t lane);

/// Lanes of cars and buses.
bool is_driven(const map::Lane& lane);

}  // namespace citykiln::roads

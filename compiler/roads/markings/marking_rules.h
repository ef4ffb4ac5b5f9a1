// Widths and dash patterns of lines by road class.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

struct LineMeasures {
  double narrow_m, broad_m;  ///< Widths of lines between lanes; of lines beside bus, cycle and leaving lanes.
  DashPattern broken, broad_broken;
  bool has_lane_lines;  ///< True if there are lines between lanes, also between opposite directions.
  bool has_edge_lines;
};

LineMeasures measures_of(const MarkingLayout& layout);

/// True for residential, service, pedestrian and lower classes.
bool is_quiet(const MarkingLayout& layout);
/// True for surfaces that can be painted; false for gravel, earth and ballast.
bool takes_paint(const MarkingLayout& layout);

/// The part of a lane, from u = low_m to high_m, that traffic towards the layout's end uses: the whole lane, or the
/// traffic's own half of a wide two-way lane. Empty (low >= high) if no such traffic uses it.
struct LaneSpan {
  double low_m, high_m;
};
LaneSpan arriving_span(const MarkingLayout& layout, std::size_t lane);

/// True for lanes of cars and buses.
bool is_driven(const map::Lane& lane);

}  // namespace citykiln::roads

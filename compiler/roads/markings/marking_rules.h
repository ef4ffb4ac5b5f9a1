// Widths and dash patterns of lines by road class. A marking layout has all data that determine the marks of a strip of
// road.
#pragma once

#include "compiler/map/countries/country_group.h"
#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// The lines of a class of roads, in metres.
struct LineMeasures {
  double narrow_m, broad_m;  ///< Widths of lines between lanes; of lines beside bus, cycle and leaving lanes.
  DashPattern broken, broad_broken;
  bool has_lane_lines;  ///< True if there are lines between lanes, also between opposite directions.
  bool has_edge_lines;
};

/// Returns the practice of a country group.
MarkingPractice practice_of(map::CountryGroup country);

/// Returns the measures for a layout's class.
LineMeasures measures_of(const MarkingLayout& layout);

/// True for every class except motorway, primary, secondary and tertiary roads.
bool is_quiet(const MarkingLayout& layout);
/// True for surfaces that can be painted; false for gravel, earth and ballast.
bool takes_paint(const MarkingLayout& layout);

/// A part of a lane, from u = low_m to high_m (metres across the strip). Empty if low_m >= high_m.
struct LaneSpan {
  double low_m, high_m;
};
/// Returns the part of a lane on which traffic towards the layout's end drives: the whole lane, or that traffic's half
/// of a wide two-way lane. Empty if there is no such traffic.
/// @param lane  Index of the lane in the layout.
LaneSpan arriving_span(const MarkingLayout& layout, std::size_t lane);

/// True for lanes of cars and buses.
bool is_driven(const map::Lane& lane);

}  // namespace citykiln::roads

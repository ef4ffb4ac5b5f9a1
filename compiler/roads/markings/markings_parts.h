// The parts of markings.h. Each adds the marks of one kind, as seen by traffic towards the layout's end, or nothing.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Cycle lanes beside cars, tinted red.
void add_tints(const MarkingLayout& layout, Marks& marks);
/// Lines between neighbouring lanes, along edges, and in two-way cycle tracks.
void add_lane_lines(const MarkingLayout& layout, Marks& marks);
void add_hatching(const MarkingLayout& layout, Marks& marks);
/// Parking bays; none within 6 m of a junction.
void add_bays(const MarkingLayout& layout, Marks& marks);
/// A stop line or a broken give-way line across the arriving lanes.
void add_stop_lines(const MarkingLayout& layout, Marks& marks);
/// Arrows by turn:lanes.
void add_arrows(const MarkingLayout& layout, Marks& marks);
/// Bicycle and BUS symbols.
void add_symbols(const MarkingLayout& layout, Marks& marks);
void add_zebra(const MarkingLayout& layout, Marks& marks);
void add_crossing(const MarkingLayout& layout, Marks& marks);
void add_rails(const MarkingLayout& layout, Marks& marks);

}  // namespace citykiln::roads

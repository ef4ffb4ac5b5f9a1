// The parts of markings.h, each of which adds what it is about, as seen by who comes to the junction at the pattern's
// end. A part that has nothing to do with a pattern adds nothing.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Cycle lanes beside cars, in a muted red.
void add_tints(const MarkingLayout& layout, Marks& marks);
/// Between neighbouring lanes, along edges, and in two-way cycle tracks.
void add_lane_lines(const MarkingLayout& layout, Marks& marks);
void add_hatching(const MarkingLayout& layout, Marks& marks);
/// Parking; none within 6 m of a junction.
void add_bays(const MarkingLayout& layout, Marks& marks);
/// A stop line, or the broken line of who gives way, across the lanes that arrive.
void add_stop_lines(const MarkingLayout& layout, Marks& marks);
/// Of turn:lanes.
void add_arrows(const MarkingLayout& layout, Marks& marks);
/// Bicycles and BUS.
void add_symbols(const MarkingLayout& layout, Marks& marks);
void add_zebra(const MarkingLayout& layout, Marks& marks);
void add_crossing(const MarkingLayout& layout, Marks& marks);
void add_rails(const MarkingLayout& layout, Marks& marks);

}  // namespace citykiln::roads

// The parts of markings.h, each of which adds what it is about, as seen by who comes to the junction at the pattern's
// end. A part that has nothing to do with a pattern adds nothing.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/pattern.h"

namespace citykiln::roads {

/// Cycle lanes beside cars, in a muted red.
void add_tints(const Pattern& pattern, Marks& marks);
/// Between neighbouring lanes, along edges, and in two-way cycle tracks.
void add_lane_lines(const Pattern& pattern, Marks& marks);
void add_hatching(const Pattern& pattern, Marks& marks);
/// Parking; none within 6 m of a junction.
void add_bays(const Pattern& pattern, Marks& marks);
/// A stop line, or the broken line of who gives way, across the lanes that arrive.
void add_stop_lines(const Pattern& pattern, Marks& marks);
/// Of turn:lanes.
void add_arrows(const Pattern& pattern, Marks& marks);
/// Bicycles and BUS.
void add_symbols(const Pattern& pattern, Marks& marks);
void add_zebra(const Pattern& pattern, Marks& marks);
void add_crossing(const Pattern& pattern, Marks& marks);
void add_rails(const Pattern& pattern, Marks& marks);

}  // namespace citykiln::roads

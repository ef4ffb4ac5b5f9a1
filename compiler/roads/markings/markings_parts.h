// The parts of marks_of(). Each function adds painted marks of one kind to a strip of road; where direction matters,
// for traffic towards the end of the strip's layout.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Adds the red tint of cycle lanes beside cars.
void add_tints(const MarkingLayout& layout, Marks& marks);
/// Adds lines between neighbouring lanes, along edges, and in two-way cycle tracks.
void add_lane_lines(const MarkingLayout& layout, Marks& marks);
/// Adds diagonal lines on buffers.
void add_hatching(const MarkingLayout& layout, Marks& marks);
/// Adds lines of parking bays, except within 6 m of a junction.
void add_bays(const MarkingLayout& layout, Marks& marks);
/// Adds a stop line across the arriving lanes, or a broken line or a row of triangles where they give way.
void add_stop_lines(const MarkingLayout& layout, Marks& marks);
/// Adds the arrows of turn:lanes.
void add_arrows(const MarkingLayout& layout, Marks& marks);
/// Adds bicycle and BUS symbols.
void add_symbols(const MarkingLayout& layout, Marks& marks);
/// Adds the bars of a zebra crossing.
void add_zebra(const MarkingLayout& layout, Marks& marks);
/// Adds the two lines of a signalled crossing, broken or, in American practice, solid.
void add_crossing(const MarkingLayout& layout, Marks& marks);
/// Adds the ramps and triangles of humps, tables and cushions.
void add_hump(const MarkingLayout& layout, Marks& marks);
/// Adds rails and sleepers.
void add_rails(const MarkingLayout& layout, Marks& marks);

}  // namespace citykiln::roads

// Markings: the painted marks on a strip of road. A strip is a set of neighbouring lanes of one kind; its layout has
// all data that determine its marks (marking_layout.h).
//
//     |  . | : | . |  bays, lane lines, centre line     Conventions of the Vienna Convention on Road Signs and Signals,
//     |__._|_:_|^._|  stop line, arrows                 all white. Dimensions from the German RMS-1, with dash patterns
//     ||||||||||||||  zebra                             of the MUTCD in towns so that every period divides 12 m.
//
// Places of marks:
//   between opposite directions   broken; two solid lines between two or more lanes each way; none in quiet streets
//   between lanes of one          broken; broad and dense if a lane leaves or merges; broad beside a bus lane
//   at a junction                 solid where drivers may have to stop or arrows assign lanes
//   edges                         of motorways, primary and secondary roads without a kerb, and before shoulders
//   cycle lanes                   a broad line, or a dense narrow one where narrow or quiet; tinted; a bicycle
//   buffers, bays                 hatched; lines between bays along the kerb, slanted or square (bay_rows.h)
//   crossings, rails              zebra or two broken lines; rails on sleepers, in the street, or in asphalt
//
// Quiet streets (residential, service, pedestrian) have no lines between cars, except where lanes merge and between
// lanes of one direction before a junction with control or arrows. Unpaved streets have no paint at all.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Returns the marks of a layout in painting order.
///
/// Guarantees: marks stay between u = 0 and the strip's width, those of a crossing between v = 0 and kCrossingLength_m.
/// A rotated layout has rotated marks. A mirrored layout (driving side, lanes and turns) has mirrored marks, except
/// letters and bicycles. Repeating marks continue across the ends of the layout. Lanes without width, and of kinds that
/// make no sense in a strip, get no marks. O(marks), at most some hundred.
Marks marks_of(const MarkingLayout& layout);

/// True if anything is painted, or there is drainage (drainage.h). Other strips are plain material and need no column
/// in the atlas.
bool needs_column(const MarkingLayout& layout);

/// Returns the colour under the marks: the material of the strip, or asphalt between the rails of a level crossing.
materials::TextureImage::Texel base_colour_of(const MarkingLayout& layout);

}  // namespace citykiln::roads

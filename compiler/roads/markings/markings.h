// Markings: what is painted on which stretch of road.
//
//     |  . | : | . |  bays, lane lines, centre line     Conventions are those of the Vienna Convention on Road Signs
//     and
//     |__._|_:_|^._|  stop line, arrows                 Signals, all white. Measures after the German RMS-1, with the
//     ||||||||||||||  zebra                             MUTCD's rhythm in towns, so that every rhythm divides 12 m.
//
// What is where:
//   between opposite directions   broken; two unbroken lines between two or more lanes each way; none in quiet streets
//   between lanes of one          broken; broad and close where one of them leaves or merges; broad beside a bus lane
//   at a junction                 unbroken where drivers may have to stop, or lanes are sorted by arrows
//   edges                         of motorways, primary and secondary roads where no kerb stands, and before shoulders
//   cycle lanes                   a broad line, or a close narrow one where narrow or quiet; tinted; a bicycle
//   buffers, bays                 hatched; a line every 6 m, 3 m slanting or 2.4 m square to the kerb
//   crossings, rails              zebra or two broken lines; rails on sleepers, in the street, or in asphalt
//
// Quiet streets (residential, service, pedestrian) have no lines between cars, unpaved ones no paint at all.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// What is painted, in order.
///
/// Guarantees: marks stay between u = 0 and the strip's width; a crossing's between v = 0 and kCrossingLength_m. The
/// pattern turned round has the marks turned round. Where the side is the other and lanes and their turns are mirrored,
/// so are the marks, but for letters and bicycles. What repeats does so over the pattern's ends. Total: lanes of no
/// width, or kinds that make no sense in a strip, are bare. O(marks), at most some hundred.
Marks marks_of(const MarkingLayout& layout);

/// Whether anything is painted: if not, the strip is plain material and needs no column.
bool is_marked(const MarkingLayout& layout);

/// What lies under the marks: the material of the strip's surface, and asphalt between the rails of a level crossing.
materials::TextureImage::Texel base_colour_of(const MarkingLayout& layout);

}  // namespace citykiln::roads

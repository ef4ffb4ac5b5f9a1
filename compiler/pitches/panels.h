// Panels: the parts of the ground that show the lines of a pitch, as pieces of a road show its markings. A panel is a
// rectangle along a line with a marking layout, a column of the tile's marking atlas.
//
//      ____________________       A line is cut into plain parts (p), whose layout is a stripe, and parts where other
//     |c|___p____|c|___p_|c|      lines come near (c). Arcs are cut into sections of equal layout. Equal layouts share
//     | |        | |     | |      a column, whatever the size of their pitches.
//     |p|        |p|     |p|
//
// A panel shows all lines within it, so panels may overlap, and it does not matter which one is on top.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/pitches/recipe.h"
#include "compiler/roads/markings/marking_layout.h"
#include "compiler/roads/pieces/pieces.h"

namespace citykiln::pitches {

/// A panel of a pitch.
struct Panel {
  Ring ring;                ///< Counter-clockwise, snapped.
  roads::PieceFrame frame;  ///< The coordinates on its layout.
  roads::MarkingLayout layout;
};

/// Returns the panels of a pitch.
///
/// @param surface      The land cover of the sports area, whose colour is under the lines.
/// @param tolerance_m  Panels are at least three tolerances wide, so that they are not merged with what is beside them.
///
/// Guarantees: every point of a line is in a panel; a panel shows all parts of lines within it. No panel with more than
/// a stripe is longer than a layout (roads::kLayoutLength_m). O(lines²).
std::vector<Panel> panels_of(const Pitch& pitch, map::LandCoverClass surface, double tolerance_m);

/// Returns the parts of land cover rings within a panel's ring, snapped. Their winding numbers are those of the rings;
/// they may run to and fro along the panel's border.
std::vector<Ring> rings_within(const Panel& panel, const std::vector<Ring>& rings);

}  // namespace citykiln::pitches

// How high a roof will be, before it is made.
#pragma once

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// What the shape's height, angle, levels or its form's pitch make of a footprint: metres over the eaves.
///
/// Told by height_m: that. Else exact where the roof is a section along a line; of roofs over a skeleton or a pole, for
/// rectangles, and within some tenths for wings of one width: the footprint counts as the rectangle of its area and
/// perimeter. 0 for flat roofs. O(n²) for the frame.
double expected_rise_m(const Polygon& footprint, const RoofShape& shape);

}  // namespace citykiln::roofs

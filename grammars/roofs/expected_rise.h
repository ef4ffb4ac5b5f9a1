// Estimates the height of a roof before it is generated.
#pragma once

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

/// Returns the height over the eaves, in metres, from the height, angle or levels of the shape, or else from the
/// default pitch of its form.
///
/// Exact if height_m is given, and for roofs of one section along a line. Other roofs are computed for the rectangle
/// with the area and the perimeter of the footprint, which is exact for rectangles and within some tenths for wings of
/// one width. Returns 0 for flat roofs and footprints of fewer than three corners. O(n²).
double expected_rise_m(const Polygon& footprint, const RoofShape& shape);

}  // namespace citykiln::roofs

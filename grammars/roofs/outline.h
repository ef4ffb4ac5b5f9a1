// Prepares the outlines over which roofs are built: cleans, splits, simplifies and offsets footprints.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::roofs {

/// Returns the polygon without repeated points, spikes, slivers that cross themselves, and rings without area. The
/// outer ring is counter-clockwise, holes are clockwise. Empty if the outer ring has no area.
Polygon cleaned(const Polygon& footprint);

/// True if no ring crosses or touches itself or another and the outer ring is counter-clockwise. Computed exactly.
/// O(n²).
bool is_simple_polygon(const Polygon& polygon);

/// True if the polygon is one simple ring without right turns.
bool is_convex(const Polygon& polygon);

/// Returns the area inside of an odd number of rings, as simple polygons. Corners where they touch are moved inward by
/// at most 2^-5 m. Slivers that are still not simple are left out.
std::vector<Polygon> split_into_simple(const Polygon& footprint);

/// Returns the polygon without corners that are within drop_m of the result, which straightens walls with small bends.
/// The result may cross itself where rings were closer than drop_m.
Polygon simplified(const Polygon& polygon, double drop_m);

/// Returns the outline of the footprint and all positions within overhang_m of its walls, with sharp corners (cut at
/// twice the overhang), on the 2^-10 m grid. Empty if the footprint is not simple or touches the outline.
Polygon offset_eaves(const Polygon& footprint, double overhang_m);

}  // namespace citykiln::roofs

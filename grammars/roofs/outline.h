// Outlines that roofs are built over: cleaned, split, simplified and offset footprints.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::roofs {

/// The polygon without repeated points, spikes and crossed slivers; outer ring counter-clockwise, holes clockwise,
/// rings without area left out. Empty if the outer ring has no area.
Polygon cleaned(const Polygon& footprint);

/// True if no ring crosses or touches itself or another and the outer ring is counter-clockwise. Exact. O(n²).
bool is_simple_polygon(const Polygon& polygon);

/// True for a simple ring without holes and without right turns.
bool is_convex(const Polygon& polygon);

/// The area inside of an odd number of rings, as simple polygons. Where they touched, corners are moved inward by at
/// most 2^-5 m. Slivers that are not simple even so are left out.
std::vector<Polygon> split_into_simple(const Polygon& footprint);

/// The polygon without corners that are within drop_m of the result, for walls that bend a little. The result may cross
/// itself where rings were closer than that.
Polygon simplified(const Polygon& polygon, double drop_m);

/// The footprint and all positions within overhang_m of its walls, with sharp corners (at most twice the overhang out).
/// On the 2^-10 m grid. Empty if the footprint is not simple or touches the outline.
Polygon offset_eaves(const Polygon& footprint, double overhang_m);

}  // namespace citykiln::roofs

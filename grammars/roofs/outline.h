// What roofs are made over: footprints taken apart, simplified, widened.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::roofs {

/// Rings without repeats and spikes, also those a hair wide that the ring crosses; outer counter-clockwise, holes
/// clockwise; rings without area are gone. If the outer one is, nothing is left.
Polygon cleaned(const Polygon& footprint);

/// No ring crosses or touches itself or another, the outer one is counter-clockwise. Exact. O(n²).
bool is_simple_polygon(const Polygon& polygon);

/// No holes, no corner that turns right, and around once.
bool is_convex(const Polygon& polygon);

/// What is inside of an odd number of rings, as polygons that are apart: where they touched, corners stand up to
/// 2^-5 m back. Slivers that are not apart even so are left out.
std::vector<Polygon> split_into_simple(const Polygon& footprint);

/// The polygon without corners that lie within drop_m of what is left: for walls that bend a little. Its rings may come
/// to cross where they were closer than that.
Polygon simplified(const Polygon& polygon, double drop_m);

/// The footprint and all within overhang_m of its walls, corners kept sharp (no farther out than twice that). Nothing
/// where the footprint is not apart, or comes to touch the outline. On the 2^-10 m grid.
Polygon offset_eaves(const Polygon& footprint, double overhang_m);

}  // namespace citykiln::roofs

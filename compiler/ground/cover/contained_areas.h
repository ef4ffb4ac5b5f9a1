// Puts smaller areas on top of the larger ones that they lie in, whatever their classes: a pond in a square.
#pragma once

#include <vector>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// Returns the polygons in their order, with LandCoverPolygon::raised_priority set. It is the highest priority_of() the
/// larger polygons in which a polygon lies, which includes their own raised priorities. It is 0 if none of them is
/// above the priority of the polygon's class. Equal priorities suffice, since the smaller of two areas is on top.
///
/// A polygon A lies in a polygon B if both are true:
/// - area_m2 of B is at least 1.05 times that of A;
/// - of the edges of A's outer ring, those inside B have at least nine tenths of the length of all. An edge is inside B
///   if the point 10 cm to the inner side of its middle is. Edges shorter than 20 cm are ignored; a ring that has only
///   such edges lies in nothing.
///
/// Yards, which are assumed, and polygons without an outer ring of three points are returned unchanged. Buildings do
/// not raise what lies in them.
///
/// Cannot fail. O(n log n), plus for each polygon its edges times the larger polygons of higher priority whose boxes
/// touch its box.
std::vector<LandCoverPolygon> with_contained_on_top(std::vector<LandCoverPolygon> areas);

}  // namespace citykiln::ground

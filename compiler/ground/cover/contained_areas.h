// Smaller areas on top of the larger ones that they lie in, whatever their classes: a pond in a square.
#pragma once

#include <vector>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// Returns the polygons with `lies_on` set: the highest priority of all polygons that a polygon lies in, where that is
/// above the priority of its class, so that it covers them. A polygon lies in a larger one (by at least 5 %) if nine
/// tenths of its outline do, measured 10 cm inside of it at the middle of each edge. Surfaces of yards, which are
/// assumed, stay below what is mapped, and nothing is raised onto buildings.
///
/// Cost: O(n log n + edges of polygons times the larger polygons of higher priority about them).
std::vector<LandCoverPolygon> with_contained_on_top(std::vector<LandCoverPolygon> areas);

}  // namespace citykiln::ground

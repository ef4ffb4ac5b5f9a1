// Smaller areas on top of the larger ones that they lie in, whatever their classes: a pond in a square.
#pragma once

#include <vector>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// Returns the polygons with `raised_priority` set: the highest priority, raised ones included, of the larger polygons
/// that each lies in, if that is above the priority of its class; else 0.
///
/// A polygon lies in one whose area_m2 is at least 1.05 times its own if edges with nine tenths of the length of its
/// outer ring do. An edge counts by one point, 10 cm inside of its middle; edges below 20 cm are skipped. Yards, which
/// are assumed, are not raised, and buildings raise nothing.
///
/// Cost: O(n log n + edges of polygons times the larger polygons of higher priority about them).
std::vector<LandCoverPolygon> with_contained_on_top(std::vector<LandCoverPolygon> areas);

}  // namespace citykiln::ground

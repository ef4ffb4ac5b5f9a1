// Smaller areas on top of the larger ones that they lie in, whatever their classes: a pond in a square.
#pragma once

#include <vector>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// Returns the polygons with `lies_on` set, so that each covers the larger polygons that it lies in: the highest of
/// their priorities, if that is above the priority of its own class.
///
/// A polygon lies in another one that is at least 5 % larger if nine tenths of the length of its outline do, tested at
/// points 10 cm inside of the middle of each edge. Surfaces of yards, which are assumed, are not raised, and buildings
/// raise nothing. Parts of polygons that the surroundings of the extent cut off are not tested.
///
/// Cost: O(n log n + edges of polygons times the larger polygons of higher priority about them).
std::vector<LandCoverPolygon> with_contained_on_top(std::vector<LandCoverPolygon> areas);

}  // namespace citykiln::ground

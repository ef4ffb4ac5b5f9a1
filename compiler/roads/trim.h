// Trims roads and strips of ground (watercourses) to the parts that a tile needs.
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the parts of a road that the box may need: runs of consecutive segments whose ground may touch the box
/// widened by the halo, mostly one run or none. Runs keep the road's id and its vertices, and together they cover the
/// same points of the widened box as the whole road. At a bend neighbouring segments end on a common mitre, so a
/// segment that may touch the box itself stays together with its neighbours. O(n).
/// @param halo_m  Width of the margin around the box.
std::vector<Road> trimmed_to(const Road& road, const Box2& box, double halo_m);
/// Returns the parts of a strip that the box may need, like trimmed_to() of a road. The segments of strips end square,
/// so they need no neighbours. O(n).
std::vector<Strip> trimmed_to(const Strip& strip, const Box2& box, double halo_m);

}  // namespace citykiln::roads

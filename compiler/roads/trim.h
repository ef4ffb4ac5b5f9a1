// Trims roads and strips to the parts that a tile needs.
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the runs of consecutive segments whose strips may touch the box widened by the halo, mostly one or none.
/// Runs keep the road's id and vertices, so they cover the same points of the widened box as the whole road. A segment
/// that may touch the box itself keeps its neighbours, since its ends lie on mitres with them. O(n).
std::vector<Road> trimmed_to(const Road& road, const Box2& box, double halo_m);
/// Returns the runs of a strip, whose segments end square, so they need no neighbours. O(n).
std::vector<Strip> trimmed_to(const Strip& strip, const Box2& box, double halo_m);

}  // namespace citykiln::roads

// Trims roads and strips to the part a tile needs.
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the runs of segments whose strip may touch the box widened by the halo, mostly one or none. Each keeps the
/// road's id and its vertices, so that within that area the runs cover exactly what the road covers. A segment that may
/// touch the box itself keeps its neighbours, since its ends lie on mitres with them. O(n).
std::vector<Road> trimmed_to(const Road& road, const Box2& box, double halo_m);
/// The same for a strip, whose segments end square.
std::vector<Strip> trimmed_to(const Strip& strip, const Box2& box, double halo_m);

}  // namespace citykiln::roads

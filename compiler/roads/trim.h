// The part of a road that a box needs to know.
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The runs of the road's segments whose strip may touch the box widened by the halo, each with the road's id, uncut
/// between their points: there the strips of the runs cover what the road's strip covers. A segment that may touch the
/// box itself has its neighbours with it, as its ends lie on the mitres with them. Often one, or none. O(n).
std::vector<Road> trimmed_to(const Road& road, const Box2& box, double halo_m);
/// Of a strip, whose segments end square.
std::vector<Strip> trimmed_to(const Strip& strip, const Box2& box, double halo_m);

}  // namespace citykiln::roads

// The part of a road that a box needs to know.
#pragma once

#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The runs of the road's segments whose strip may touch the box, each with the road's id, uncut between their points:
/// in the box the strips of the runs cover what the road's strip covers. Often one, or none. O(n).
std::vector<Road> trimmed_to(const Road& road, const Box2& box);
std::vector<Strip> trimmed_to(const Strip& strip, const Box2& box);

}  // namespace citykiln::roads

// House numbers: odd on the left of a street, even on its right.
#pragma once

#include "compiler/invent/town/town_lots.h"

namespace citykiln::invent {

/// Returns a number for each lot; numbers of a street grow along it. O(n log n).
std::vector<int> house_numbers(const std::vector<StreetEdge>& edges, const std::vector<TownLot>& lots);

}  // namespace citykiln::invent

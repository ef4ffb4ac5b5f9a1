// Joins lines of equal tags end to end, as mappers draw them.
#pragma once

#include <vector>

#include "compiler/invent/invented_map.h"

namespace citykiln::invent {

/// Returns the lines, joined where they have equal tags and share an end: the pair that goes straightest on is joined
/// first, and no two lines that turn by more than a right angle are. Points on a straight line that no other line
/// and none of `points` has are left out. The order is that of the first line of each. O(n log n).
std::vector<InventedLine> join_lines(const std::vector<InventedLine>& lines, const std::vector<InventedPoint>& points);

}  // namespace citykiln::invent

// Joins lines of equal tags end to end, as mappers draw them.
#pragma once

#include <vector>

#include "compiler/invent/invented_map.h"

namespace citykiln::invent {

/// Returns the lines, joined where they have equal tags and share an end. Where several lines meet, the pair that goes
/// straightest on is joined first. Lines that would turn by more than a right angle are not joined. Points on a
/// straight line are left out, unless another line or one of `points` has them. The order is that of the first line of
/// each. O(n log n).
std::vector<InventedLine> join_lines(const std::vector<InventedLine>& lines, const std::vector<InventedPoint>& points);

}  // namespace citykiln::invent

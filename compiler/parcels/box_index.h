// Visits boxes near a place without memory of its own (geometry/box_grid.h).
#pragma once

#include <span>

#include "compiler/geometry/box_grid.h"

namespace citykiln::parcels {

/// Calls visit(index) for every box that touches `box`, and for some near it; perhaps several times for one box. Ends
/// after the first call that returns true, and then returns true.
template <typename Visit>
bool any_about(const BoxGrid& grid, const Box2& box, Visit visit) {
  if (grid.box.is_empty() || !grid.box.touches(box)) return false;
  const BucketRange range = grid.buckets.range(box);
  for (int row = range.first_row; row <= range.last_row; ++row)
    for (int column = range.first_column; column <= range.last_column; ++column)
      for (const std::uint32_t i : grid.numbers.in(grid.buckets.index(column, row)))
        if (visit(i)) return true;
  return false;
}

inline Box2 box_of_segment(Vec2 a, Vec2 b) {
  Box2 box;
  box.grow(a), box.grow(b);
  return box;
}

}  // namespace citykiln::parcels

// A grid of square buckets that finds boxes near a point or box. Buckets begin at whole multiples of their side, so a
// result depends only on boxes that touch the same buckets, not on the extent of all boxes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/bucket_grid.h"

namespace citykiln {

struct BoxGrid {
  Box2 box;  ///< The box of all buckets, without its eastern and northern sides.
  BucketGrid buckets;
  BucketItems numbers;  ///< Indices of boxes, ascending in each bucket.
};

/// Sorts boxes, none of them empty, into buckets. bucket_m > 0. Cost: linear in boxes and the buckets that they touch.
BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m);

/// Sorts boxes into buckets as above, except into buckets for which `is_in(index of the box, bucket)` is false.
BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m,
                const std::function<bool(std::uint32_t, const Box2&)>& is_in);

/// The indices of all boxes that contain p, and some near it, ascending. O(1).
std::span<const std::uint32_t> boxes_about(const BoxGrid& grid, Vec2 p);

/// The indices of all boxes that touch a box, and some near it, ascending, each once. O(buckets + boxes in them).
std::vector<std::uint32_t> boxes_about(const BoxGrid& grid, const Box2& box);

/// True if boxes_about() is not empty. O(rows of buckets).
bool is_any_about(const BoxGrid& grid, const Box2& box);

/// Calls visit(index) for every box that touches `box`, and for some near it; perhaps several times for one box. Ends
/// after the first call that returns true, and then returns true. Allocates nothing.
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

}  // namespace citykiln

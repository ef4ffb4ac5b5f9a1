// Boxes sorted into square buckets, to find those about a point.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"

namespace citykiln {

struct BoxGrid {
  Box2 box;
  double bucket_m = 0;
  int columns = 0, rows = 0;
  std::vector<std::uint32_t> starts;   ///< columns * rows + 1 offsets into numbers.
  std::vector<std::uint32_t> numbers;  ///< Of boxes, ascending in each bucket.
};

/// Cost: linear in boxes and in the buckets that they touch.
BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m);

/// The same, but a box is left out of buckets that it touches and `is_in(box's number, bucket)` denies.
BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m,
                const std::function<bool(std::uint32_t, const Box2&)>& is_in);

/// The numbers of all boxes that may hold p, and some more, ascending. O(1).
std::span<const std::uint32_t> boxes_about(const BoxGrid& grid, Vec2 p);

/// The numbers of all boxes that may touch a box, and some more, ascending, each once. O(buckets + boxes in them).
std::vector<std::uint32_t> boxes_about(const BoxGrid& grid, const Box2& box);

/// True where boxes_about() finds any. O(rows of buckets).
bool is_any_about(const BoxGrid& grid, const Box2& box);

}  // namespace citykiln

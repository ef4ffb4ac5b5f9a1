// A grid of square buckets that finds boxes near a point or box. Buckets begin at whole multiples of their side, so
// what is found depends only on boxes that touch the same buckets, not on how far the others extend.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/bucket_grid.h"

namespace citykiln {

struct BoxGrid {
  Box2 box;  ///< Of all buckets; its eastern and northern sides do not belong to it.
  BucketGrid buckets;
  BucketItems numbers;  ///< Indices of boxes, ascending in each bucket.
};

/// Sorts boxes, none of them empty, into buckets. bucket_m > 0. Cost: linear in boxes and the buckets that they touch.
BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m);

/// Like the above; leaves a box out of touched buckets for which `is_in(index, bucket)` is false.
BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m,
                const std::function<bool(std::uint32_t, const Box2&)>& is_in);

/// The indices of all boxes that contain p, and some near it, ascending. O(1).
std::span<const std::uint32_t> boxes_about(const BoxGrid& grid, Vec2 p);

/// The indices of all boxes that touch a box, and some near it, ascending, each once. O(buckets + boxes in them).
std::vector<std::uint32_t> boxes_about(const BoxGrid& grid, const Box2& box);

/// True if boxes_about() is not empty. O(rows of buckets).
bool is_any_about(const BoxGrid& grid, const Box2& box);

}  // namespace citykiln

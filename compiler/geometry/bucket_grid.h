// Square buckets over a box of the plane, and items sorted into buckets.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"

namespace citykiln {

/// Columns and rows of buckets, first and last.
struct BucketRange {
  int first_column = 0, last_column = 0, first_row = 0, last_row = 0;
};

/// A lattice of square buckets, numbered row by row from its south-west corner.
struct BucketGrid {
  Vec2 corner;
  double bucket_m = 0;
  int columns = 0, rows = 0;

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  /// The column of a place; places outside the lattice belong to its outermost columns. row() does the like.
  int column(double x) const { return place(x - corner.x, columns); }
  int row(double y) const { return place(y - corner.y, rows); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  std::size_t index(Vec2 p) const { return index(column(p.x), row(p.y)); }
  Vec2 corner_of(int column, int row) const { return corner + Vec2{column * bucket_m, row * bucket_m}; }
  /// The buckets that a box touches.
  BucketRange range(const Box2& box) const {
    return {column(box.min.x), column(box.max.x), row(box.min.y), row(box.max.y)};
  }

 private:
  int place(double offset_m, int count) const {
    return static_cast<int>(std::clamp(offset_m / bucket_m, 0.0, count - 1.0));
  }
};

/// Returns a lattice that covers a box, which must not be empty. Its corner is a whole multiple of bucket_m, so
/// lattices over different boxes have the same buckets where they overlap. bucket_m > 0.
inline BucketGrid grid_over(const Box2& box, double bucket_m) {
  assert(!box.is_empty() && bucket_m > 0);
  const Vec2 corner{std::floor(box.min.x / bucket_m) * bucket_m, std::floor(box.min.y / bucket_m) * bucket_m};
  return {corner, bucket_m, static_cast<int>((box.max.x - corner.x) / bucket_m) + 1,
          static_cast<int>((box.max.y - corner.y) / bucket_m) + 1};
}

/// Calls visit(column, row) for each bucket of a range, row by row.
template <typename Visit>
void for_each_bucket(const BucketRange& range, Visit visit) {
  for (int row = range.first_row; row <= range.last_row; ++row)
    for (int column = range.first_column; column <= range.last_column; ++column) visit(column, row);
}

/// Item indices by bucket, in one flat vector.
struct BucketItems {
  std::vector<std::uint32_t> starts;  ///< One for each bucket and one more: offsets into `items`.
  std::vector<std::uint32_t> items;

  std::span<const std::uint32_t> in(std::size_t bucket) const {
    assert(bucket + 1 < starts.size());
    return std::span(items).subspan(starts[bucket], starts[bucket + 1] - starts[bucket]);
  }
};

/// Sorts items into buckets by counting. Items of one bucket keep the order in which they are visited. O(buckets +
/// visits).
/// @param each  Called twice as each(visit); must call visit(bucket, item) in the same order both times.
template <typename Each>
BucketItems sort_into_buckets(std::size_t bucket_count, Each each) {
  BucketItems sorted;
  sorted.starts.assign(bucket_count + 1, 0);
  each([&](std::size_t bucket, std::uint32_t) { ++sorted.starts[bucket + 1]; });
  for (std::size_t i = 1; i < sorted.starts.size(); ++i) sorted.starts[i] += sorted.starts[i - 1];
  sorted.items.resize(sorted.starts.back());
  std::vector<std::uint32_t> next(sorted.starts.begin(), sorted.starts.end() - 1);
  each([&](std::size_t bucket, std::uint32_t item) { sorted.items[next[bucket]++] = item; });
  return sorted;
}

}  // namespace citykiln

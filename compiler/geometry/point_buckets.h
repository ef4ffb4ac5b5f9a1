// A grid of square buckets that finds grid points near a point or triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"

namespace citykiln {

/// Indices of points, sorted into buckets of about two points each if these are evenly spread.
struct PointBuckets {
  GridPoint min;          ///< South-western corner.
  std::int64_t side = 1;  ///< Side of a bucket, grid steps.
  double per_side = 1;    ///< 1 / side.
  std::int64_t columns = 1, rows = 1;
  std::vector<std::uint32_t> starts, ends;  ///< Offsets into `members` of each bucket, row by row.
  std::vector<std::uint32_t> members;       ///< Indices of points, ascending in each bucket.

  std::int64_t column(std::int64_t x) const { return whole_sides(x - min.x, columns - 1); }
  std::int64_t row(std::int64_t y) const { return whole_sides(y - min.y, rows - 1); }
  std::size_t index(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row * columns + column);
  }
  std::span<const std::uint32_t> bucket(std::int64_t column, std::int64_t row) const {
    const std::size_t i = index(column, row);
    return std::span(members).subspan(starts[i], ends[i] - starts[i]);
  }

 private:
  // steps / side, rounded down and limited to 0 … most, without the slow integer division
  std::int64_t whole_sides(std::int64_t steps, std::int64_t most) const {
    if (steps <= 0) return 0;
    auto whole = static_cast<std::int64_t>(static_cast<double>(steps) * per_side);
    if (whole * side > steps) --whole;
    if ((whole + 1) * side <= steps) ++whole;
    return std::min(whole, most);
  }
};

/// Sorts points into buckets. O(n).
/// @param min, max The box of the buckets; points outside fall into the outermost buckets.
PointBuckets bucket_points(std::span<const GridPoint> points, GridPoint min, GridPoint max);

/// Removes a point. O(points in its bucket).
void remove_point(PointBuckets& buckets, std::uint32_t index, GridPoint place);

/// Returns the index of the point nearest to p; on a tie the first by (x, y). There must be at least one point. O(1)
/// expected for evenly spread points.
std::uint32_t nearest_point_index(const PointBuckets& buckets, std::span<const GridPoint> points, GridPoint p);

/// An interval of x in grid steps; empty if low > high.
struct XInterval {
  std::int64_t low, high;
};
/// Returns the x interval of a triangle's part with y in low_y … high_y, widened by a few steps.
XInterval x_interval_of_triangle(const std::array<GridPoint, 3>& corners, std::int64_t low_y, std::int64_t high_y);

/// Calls visit(index) for every point within a grid step of a triangle (in x and y), and for some points farther away,
/// until visit returns true. Returns true if a call of visit did.
template <typename Visit>
bool any_near_triangle(const PointBuckets& buckets, const std::array<GridPoint, 3>& corners, Visit visit) {
  const auto [low_x, high_x] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [low_y, high_y] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const std::int64_t last = buckets.row(high_y + 1);
  // the interval of each row matters only for triangles over more than two columns
  const XInterval all{low_x - 1, high_x + 1};
  const bool is_narrow = buckets.column(all.high) - buckets.column(all.low) < 2;
  for (std::int64_t row = buckets.row(low_y - 1); row <= last; ++row) {
    // the outermost rows are unbounded
    const std::int64_t low = row == 0 ? low_y : buckets.min.y + row * buckets.side - 1;
    const std::int64_t high = row == buckets.rows - 1 ? high_y : buckets.min.y + (row + 1) * buckets.side + 1;
    const XInterval run = is_narrow ? all : x_interval_of_triangle(corners, low, high);
    if (run.low > run.high) continue;
    for (std::int64_t column = buckets.column(run.low); column <= buckets.column(run.high); ++column)
      for (const std::uint32_t i : buckets.bucket(column, row))
        if (visit(i)) return true;
  }
  return false;
}

}  // namespace citykiln

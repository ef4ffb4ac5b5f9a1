// Points of the grid sorted into square buckets, to ask which lie near a place or a triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"

namespace citykiln {

/// Twice the area of a, b, c: positive where they turn left. Exact on the grid.
inline std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// About two points a bucket where they are spread evenly. Refers to points by their index, not to where they are kept.
struct PointBuckets {
  GridPoint min;
  std::int64_t side = 1;
  double per_side = 1;  ///< 1 / side.
  std::int64_t columns = 1, rows = 1;
  std::vector<std::uint32_t> starts, ends;  ///< One a bucket, row by row: offsets into `members`.
  std::vector<std::uint32_t> members;       ///< Indices of points, rising in each bucket.

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
  // steps / side, rounded down, 0 … most: processors are slow at dividing whole numbers
  std::int64_t whole_sides(std::int64_t steps, std::int64_t most) const {
    if (steps <= 0) return 0;
    auto whole = static_cast<std::int64_t>(static_cast<double>(steps) * per_side);
    if (whole * side > steps) --whole;
    if ((whole + 1) * side <= steps) ++whole;
    return std::min(whole, most);
  }
};

/// @param min, max  What the points are spread over; those outside fall into the rim. O(n).
PointBuckets bucket_points(std::span<const GridPoint> points, GridPoint min, GridPoint max);

/// Takes a point out. O(points in its bucket).
void remove_point(PointBuckets& buckets, std::uint32_t index, GridPoint place);

/// The point nearest to p, of equals the first in order of place. There must be one. O(1) expected where points are
/// spread evenly.
std::uint32_t nearest_point(const PointBuckets& buckets, std::span<const GridPoint> points, GridPoint p);

/// The x between which a triangle lies in the rows low_y … high_y, or wider by a few steps; low > high: nowhere.
struct XInterval {
  std::int64_t low, high;
};
XInterval x_interval_of_triangle(const std::array<GridPoint, 3>& corners, std::int64_t low_y, std::int64_t high_y);

/// Calls visit(index) for every point in the buckets near a triangle: all points within a grid step of it (in x and in
/// y), and some around. Stops where visit returns true; whether it did.
template <typename Visit>
bool any_near_triangle(const PointBuckets& buckets, const std::array<GridPoint, 3>& corners, Visit visit) {
  const auto [low_x, high_x] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [low_y, high_y] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const std::int64_t last = buckets.row(high_y + 1);
  // in one column or two there is nothing to leave out
  const XInterval all{low_x - 1, high_x + 1};
  const bool is_narrow = buckets.column(all.high) - buckets.column(all.low) < 2;
  for (std::int64_t row = buckets.row(low_y - 1); row <= last; ++row) {
    // the rim's buckets have no end outwards
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

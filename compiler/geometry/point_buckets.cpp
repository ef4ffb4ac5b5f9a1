#include "compiler/geometry/point_buckets.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "compiler/geometry/bucket_grid.h"

namespace citykiln {
namespace {

std::int64_t squared_distance(GridPoint a, GridPoint b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

struct Nearest {
  std::uint32_t index = 0;
  std::int64_t squared = -1;  // negative: no point found
};

// Tests the points in all buckets at a distance of `ring` columns or rows from a bucket.
void look_at_ring(Nearest& nearest, const PointBuckets& buckets, std::span<const GridPoint> points, GridPoint p,
                  std::int64_t ring) {
  const std::int64_t column = buckets.column(p.x), row = buckets.row(p.y);
  for (std::int64_t r = std::max<std::int64_t>(row - ring, 0); r <= std::min(row + ring, buckets.rows - 1); ++r) {
    const bool is_side = r == row - ring || r == row + ring;
    for (std::int64_t c = column - ring; c <= column + ring; c += is_side ? 1 : 2 * ring) {
      if (c < 0 || c >= buckets.columns) continue;
      for (const std::uint32_t i : buckets.bucket(c, r)) {
        const std::int64_t squared = squared_distance(p, points[i]);
        const bool is_nearer = nearest.squared < 0 || squared < nearest.squared ||
                               (squared == nearest.squared && points[i] < points[nearest.index]);
        if (is_nearer) nearest = {i, squared};
      }
    }
  }
}

}  // namespace

PointBuckets bucket_points(std::span<const GridPoint> points, GridPoint min, GridPoint max) {
  assert(min.x <= max.x && min.y <= max.y);
  PointBuckets buckets;
  buckets.min = min;
  const double width = static_cast<double>(std::max<std::int64_t>(max.x - min.x, 1));
  const double height = static_cast<double>(std::max<std::int64_t>(max.y - min.y, 1));
  const double wanted = std::max(1.0, static_cast<double>(points.size()) / 2);
  // at most 1024 a side, for long and thin boxes
  const double side = std::max({std::sqrt(width * height / wanted), width / 1024, height / 1024, 1.0});
  buckets.side = static_cast<std::int64_t>(std::ceil(side));
  buckets.per_side = 1 / static_cast<double>(buckets.side);
  buckets.columns = (max.x - min.x) / buckets.side + 1;
  buckets.rows = (max.y - min.y) / buckets.side + 1;
  const auto index = [&](GridPoint p) { return buckets.index(buckets.column(p.x), buckets.row(p.y)); };
  BucketItems sorted = sort_into_buckets(static_cast<std::size_t>(buckets.columns * buckets.rows), [&](auto visit) {
    for (std::uint32_t i = 0; i < points.size(); ++i) visit(index(points[i]), i);
  });
  buckets.starts.assign(sorted.starts.begin(), sorted.starts.end() - 1);
  buckets.ends.assign(sorted.starts.begin() + 1, sorted.starts.end());
  buckets.members = std::move(sorted.items);
  return buckets;
}

void remove_point(PointBuckets& buckets, std::uint32_t index, GridPoint place) {
  const std::size_t bucket = buckets.index(buckets.column(place.x), buckets.row(place.y));
  const auto first = buckets.members.begin() + buckets.starts[bucket],
             last = buckets.members.begin() + buckets.ends[bucket];
  const auto at = std::find(first, last, index);
  if (at == last) return;
  std::move(at + 1, last, at);
  --buckets.ends[bucket];
}

std::uint32_t nearest_point_index(const PointBuckets& buckets, std::span<const GridPoint> points, GridPoint p) {
  assert(!buckets.members.empty());
  Nearest nearest;
  const std::int64_t rings = std::max(buckets.columns, buckets.rows);
  for (std::int64_t ring = 0; ring <= rings; ++ring) {
    // a lower bound on the distance to points in this ring and beyond
    const std::int64_t least = std::max<std::int64_t>(ring - 1, 0) * buckets.side;
    if (nearest.squared >= 0 && nearest.squared < least * least) break;
    look_at_ring(nearest, buckets, points, p, ring);
  }
  return nearest.index;
}

XInterval x_interval_of_triangle(const std::array<GridPoint, 3>& corners, std::int64_t low_y, std::int64_t high_y) {
  XInterval run{INT64_MAX, INT64_MIN};
  const auto reach = [&](double x) {
    run.low = std::min(run.low, static_cast<std::int64_t>(std::floor(x)) - 2);
    run.high = std::max(run.high, static_cast<std::int64_t>(std::ceil(x)) + 2);
  };
  for (int i = 0; i < 3; ++i) {
    GridPoint a = corners[i], b = corners[(i + 1) % 3];
    if (b.y < a.y) std::swap(a, b);
    if (a.y > high_y || b.y < low_y) continue;
    const double slope = b.y > a.y ? static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y) : 0;
    const auto x_at = [&](std::int64_t y) { return static_cast<double>(a.x) + static_cast<double>(y - a.y) * slope; };
    reach(a.y >= low_y ? static_cast<double>(a.x) : x_at(low_y));
    reach(b.y <= high_y ? static_cast<double>(b.x) : x_at(high_y));
  }
  return run;
}

}  // namespace citykiln

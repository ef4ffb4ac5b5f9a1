#include "compiler/geometry/box_grid.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace citykiln {
namespace {

bool covers(const BoxGrid& grid, Vec2 p) {
  return p.x >= grid.box.min.x && p.y >= grid.box.min.y && p.x < grid.box.max.x && p.y < grid.box.max.y;
}

bool overlaps(const BoxGrid& grid, const Box2& box) {
  return box.max.x >= grid.box.min.x && box.max.y >= grid.box.min.y && box.min.x < grid.box.max.x &&
         box.min.y < grid.box.max.y;
}

}  // namespace

BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m) {
  return grid_of(boxes, bucket_m, [](std::uint32_t, const Box2&) { return true; });
}

BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m,
                const std::function<bool(std::uint32_t, const Box2&)>& is_in) {
  assert(bucket_m > 0 && std::ranges::all_of(boxes, [](const Box2& box) { return !box.is_empty(); }));
  BoxGrid grid;
  for (const Box2& box : boxes) grid.box.grow(box.min), grid.box.grow(box.max);
  if (boxes.empty()) return grid;
  grid.buckets = grid_over(grid.box, bucket_m);
  grid.box = {grid.buckets.corner, grid.buckets.corner_of(grid.buckets.columns, grid.buckets.rows)};
  std::vector<std::pair<std::size_t, std::uint32_t>> found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for_each_bucket(grid.buckets.range(boxes[i]), [&](int column, int row) {
      const Vec2 corner = grid.buckets.corner_of(column, row);
      if (is_in(i, {corner, corner + Vec2{bucket_m, bucket_m}})) found.emplace_back(grid.buckets.index(column, row), i);
    });
  grid.numbers = sort_into_buckets(grid.buckets.size(), [&](auto visit) {
    for (const auto& [bucket, number] : found) visit(bucket, number);
  });
  return grid;
}

std::span<const std::uint32_t> boxes_about(const BoxGrid& grid, Vec2 p) {
  if (!covers(grid, p)) return {};
  return grid.numbers.in(grid.buckets.index(p));
}

std::vector<std::uint32_t> boxes_about(const BoxGrid& grid, const Box2& box) {
  std::vector<std::uint32_t> found;
  if (!overlaps(grid, box)) return found;
  for_each_bucket(grid.buckets.range(box), [&](int column, int row) {
    const auto here = grid.numbers.in(grid.buckets.index(column, row));
    found.insert(found.end(), here.begin(), here.end());
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool is_any_about(const BoxGrid& grid, const Box2& box) {
  if (!overlaps(grid, box)) return false;
  const BucketRange range = grid.buckets.range(box);
  const std::vector<std::uint32_t>& starts = grid.numbers.starts;
  for (int row = range.first_row; row <= range.last_row; ++row)
    if (starts[grid.buckets.index(range.first_column, row)] < starts[grid.buckets.index(range.last_column, row) + 1])
      return true;
  return false;
}

}  // namespace citykiln

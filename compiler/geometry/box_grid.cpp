#include "compiler/geometry/box_grid.h"

#include <algorithm>

namespace citykiln {
namespace {

struct BucketRange {
  int first_column, last_column, first_row, last_row;
};

int bucket_of(double offset_m, double bucket_m, int count) {
  return static_cast<int>(std::clamp(offset_m / bucket_m, 0.0, count - 1.0));
}

BucketRange range_of(const BoxGrid& grid, const Box2& box) {
  return {bucket_of(box.min.x - grid.box.min.x, grid.bucket_m, grid.columns),
          bucket_of(box.max.x - grid.box.min.x, grid.bucket_m, grid.columns),
          bucket_of(box.min.y - grid.box.min.y, grid.bucket_m, grid.rows),
          bucket_of(box.max.y - grid.box.min.y, grid.bucket_m, grid.rows)};
}

template <typename Visit>
void for_each_bucket(const BoxGrid& grid, const Box2& box, Visit visit) {
  const BucketRange range = range_of(grid, box);
  for (int row = range.first_row; row <= range.last_row; ++row)
    for (int column = range.first_column; column <= range.last_column; ++column)
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column));
}

Box2 box_of(const BoxGrid& grid, std::size_t bucket) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  const Vec2 corner = grid.box.min + Vec2{static_cast<double>(bucket % columns) * grid.bucket_m,
                                          static_cast<double>(bucket / columns) * grid.bucket_m};
  return {corner, corner + Vec2{grid.bucket_m, grid.bucket_m}};
}

std::span<const std::uint32_t> numbers_in(const BoxGrid& grid, std::size_t bucket) {
  return std::span(grid.numbers).subspan(grid.starts[bucket], grid.starts[bucket + 1] - grid.starts[bucket]);
}

}  // namespace

BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m) {
  return grid_of(boxes, bucket_m, [](std::uint32_t, const Box2&) { return true; });
}

BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m,
                const std::function<bool(std::uint32_t, const Box2&)>& is_in) {
  BoxGrid grid;
  grid.bucket_m = bucket_m;
  for (const Box2& box : boxes) grid.box.grow(box.min), grid.box.grow(box.max);
  if (boxes.empty()) return grid;
  grid.columns = static_cast<int>(grid.box.width() / bucket_m) + 1;
  grid.rows = static_cast<int>(grid.box.height() / bucket_m) + 1;
  std::vector<std::pair<std::size_t, std::uint32_t>> found;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for_each_bucket(grid, boxes[i], [&](std::size_t bucket) {
      if (is_in(i, box_of(grid, bucket))) found.emplace_back(bucket, i);
    });
  grid.starts.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) + 1, 0);
  for (const auto& [bucket, number] : found) ++grid.starts[bucket + 1];
  for (std::size_t i = 1; i < grid.starts.size(); ++i) grid.starts[i] += grid.starts[i - 1];
  grid.numbers.resize(grid.starts.back());
  std::vector<std::uint32_t> next(grid.starts.begin(), grid.starts.end() - 1);
  for (const auto& [bucket, number] : found) grid.numbers[next[bucket]++] = number;
  return grid;
}

std::span<const std::uint32_t> boxes_about(const BoxGrid& grid, Vec2 p) {
  if (grid.numbers.empty() || !grid.box.contains(p)) return {};
  const auto column = static_cast<std::size_t>(bucket_of(p.x - grid.box.min.x, grid.bucket_m, grid.columns));
  const auto row = static_cast<std::size_t>(bucket_of(p.y - grid.box.min.y, grid.bucket_m, grid.rows));
  return numbers_in(grid, row * static_cast<std::size_t>(grid.columns) + column);
}

std::vector<std::uint32_t> boxes_about(const BoxGrid& grid, const Box2& box) {
  std::vector<std::uint32_t> found;
  if (grid.numbers.empty() || !grid.box.touches(box)) return found;
  for_each_bucket(grid, box, [&](std::size_t bucket) {
    const auto here = numbers_in(grid, bucket);
    found.insert(found.end(), here.begin(), here.end());
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool is_any_about(const BoxGrid& grid, const Box2& box) {
  if (grid.numbers.empty() || !grid.box.touches(box)) return false;
  const BucketRange range = range_of(grid, box);
  for (int row = range.first_row; row <= range.last_row; ++row) {
    const std::size_t west = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns);
    if (grid.starts[west + static_cast<std::size_t>(range.first_column)] <
        grid.starts[west + static_cast<std::size_t>(range.last_column) + 1])
      return true;
  }
  return false;
}

}  // namespace citykiln

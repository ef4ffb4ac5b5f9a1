#include "compiler/geometry/box_grid.h"

#include <cmath>

namespace citykiln {
namespace {

struct BucketRange {
  int first_column, last_column, first_row, last_row;
};

int bucket_of(double offset_m, double bucket_m, int count) {
  return static_cast<int>(std::clamp(std::floor(offset_m / bucket_m), 0.0, count - 1.0));
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

std::span<const std::uint32_t> numbers_in(const BoxGrid& grid, std::size_t bucket) {
  return std::span(grid.numbers).subspan(grid.starts[bucket], grid.starts[bucket + 1] - grid.starts[bucket]);
}

}  // namespace

BoxGrid grid_of(std::span<const Box2> boxes, double bucket_m) {
  BoxGrid grid;
  grid.bucket_m = bucket_m;
  for (const Box2& box : boxes) grid.box.grow(box.min), grid.box.grow(box.max);
  if (boxes.empty()) return grid;
  grid.columns = static_cast<int>(grid.box.width() / bucket_m) + 1;
  grid.rows = static_cast<int>(grid.box.height() / bucket_m) + 1;
  grid.starts.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows) + 1, 0);
  for (const Box2& box : boxes) for_each_bucket(grid, box, [&](std::size_t bucket) { ++grid.starts[bucket + 1]; });
  for (std::size_t i = 1; i < grid.starts.size(); ++i) grid.starts[i] += grid.starts[i - 1];
  grid.numbers.resize(grid.starts.back());
  std::vector<std::uint32_t> next(grid.starts.begin(), grid.starts.end() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for_each_bucket(grid, boxes[i], [&](std::size_t bucket) { grid.numbers[next[bucket]++] = i; });
  return grid;
}

std::span<const std::uint32_t> boxes_about(const BoxGrid& grid, Vec2 p) {
  if (grid.numbers.empty() || !grid.box.contains(p)) return {};
  const BucketRange at = range_of(grid, {p, p});
  return numbers_in(grid, static_cast<std::size_t>(at.first_row) * static_cast<std::size_t>(grid.columns) +
                              static_cast<std::size_t>(at.first_column));
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

}  // namespace citykiln

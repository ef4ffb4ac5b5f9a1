#include "compiler/surroundings/cells.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/contract/erase_repeated.h"

namespace citykiln::surroundings {
namespace {

double side_at(double away_m, bool is_rough) {
  if (is_rough) return away_m * kShareWhereRough;
  return away_m * (away_m < kPlainFrom_m ? kShareOfDistance : kShareOfPlain);
}

void divide_cell(const Cell& cell, const CellSizes& sizes, std::vector<Cell>& cells) {
  const Box2 box = cell.box();
  const double away_m = sizes.away_m(box);
  const bool is_small = cell.side_m <= side_at(away_m, true) ||
                        (cell.side_m <= side_at(away_m, false) && !sizes.is_rough(box)) ||
                        (cell.side_m <= away_m * kShareOfSea && sizes.is_sea && sizes.is_sea(box));
  if (cell.side_m <= sizes.finest_m || is_small) return cells.push_back(cell);
  const std::int32_t half_m = cell.side_m / 2;
  for (const std::int32_t y : {0, half_m})
    for (const std::int32_t x : {0, half_m}) divide_cell({cell.x_m + x, cell.y_m + y, half_m}, sizes, cells);
}

std::int32_t floored(double v, std::int32_t step) { return static_cast<std::int32_t>(std::floor(v / step)) * step; }

std::uint64_t corner_key(std::int32_t x, std::int32_t y, std::int32_t side) {
  // coordinates are within 2^21, and sides powers of two
  const auto bits = [](std::int32_t v) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v + (1 << 22)));
  };
  return bits(x) << 36 | bits(y) << 12 | static_cast<std::uint64_t>(side / 4);
}

}  // namespace

std::vector<Cell> cells_over(const Box2& box, const CellSizes& sizes) {
  assert(!box.is_empty() && sizes.finest_m > 0);
  std::vector<Cell> cells;
  for (std::int32_t y = floored(box.min.y, kLargestCell_m); y < box.max.y; y += kLargestCell_m)
    for (std::int32_t x = floored(box.min.x, kLargestCell_m); x < box.max.x; x += kLargestCell_m)
      divide_cell({x, y, kLargestCell_m}, sizes, cells);
  return cells;
}

CellIndex::CellIndex(const std::vector<Cell>& cells) {
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    by_corner_.emplace(corner_key(cells[i].x_m, cells[i].y_m, cells[i].side_m), i);
    sides_m_.push_back(cells[i].side_m);
  }
  sort_unique(sides_m_);
}

std::uint32_t CellIndex::at(Vec2 place) const {
  for (const std::int32_t side : sides_m_) {
    const auto found = by_corner_.find(corner_key(floored(place.x, side), floored(place.y, side), side));
    if (found != by_corner_.end()) return found->second;
  }
  return kNone;
}

}  // namespace citykiln::surroundings

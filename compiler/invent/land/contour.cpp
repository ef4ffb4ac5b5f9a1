#include "compiler/invent/land/contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::invent {
namespace {

// crossings keep off the lattice's points, so that rings of neighbouring squares do not touch
constexpr double kOffPoint = 0.02;

/// Follows the border of the area above zero from square to square. Edges of the lattice are numbered: 2 i runs from
/// point i to the east, 2 i + 1 to the north. The lattice has a rim of values below zero, at the places of its border.
class Marching {
 public:
  explicit Marching(const ValueGrid& grid) : grid_(grid), columns_(grid.columns + 2), rows_(grid.rows + 2) {
    next_.assign(static_cast<std::size_t>(columns_) * rows_ * 2, kNoEdge);
    for (int row = 0; row + 1 < rows_; ++row)
      for (int column = 0; column + 1 < columns_; ++column) link_square(column, row);
  }

  std::vector<Ring> rings() {
    std::vector<Ring> all;
    for (std::size_t edge = 0; edge < next_.size(); ++edge)
      if (next_[edge] != kNoEdge) all.push_back(ring_from(edge));
    return all;
  }

 private:
  static constexpr std::uint32_t kNoEdge = 0xffffffff;

  bool is_rim(int column, int row) const {
    return column == 0 || row == 0 || column == columns_ - 1 || row == rows_ - 1;
  }
  double value(int column, int row) const { return is_rim(column, row) ? -1 : grid_.at(column - 1, row - 1); }
  Vec2 place(int column, int row) const {
    return grid_.point(std::clamp(column - 1, 0, grid_.columns - 1), std::clamp(row - 1, 0, grid_.rows - 1));
  }
  std::uint32_t edge(int column, int row, bool is_northward) const {
    return static_cast<std::uint32_t>((static_cast<std::size_t>(row) * columns_ + column) * 2 + (is_northward ? 1 : 0));
  }

  // Enters the ways through a square, with the area on the left.
  void link_square(int column, int row) {
    const bool sw = value(column, row) > 0, se = value(column + 1, row) > 0, nw = value(column, row + 1) > 0,
               ne = value(column + 1, row + 1) > 0;
    const std::uint32_t south = edge(column, row, false), north = edge(column, row + 1, false),
                        west = edge(column, row, true), east = edge(column + 1, row, true);
    // each corner alone above or below zero, then pairs side by side
    if (sw && !se && !nw) next_[south] = west;
    if (se && !sw && !ne) next_[east] = south;
    if (ne && !se && !nw) next_[north] = east;
    if (nw && !sw && !ne) next_[west] = north;
    if (!sw && se && nw && ne) next_[west] = south;
    if (!se && sw && nw && ne) next_[south] = east;
    if (!ne && sw && se && nw) next_[east] = north;
    if (!nw && sw && se && ne) next_[north] = west;
    if (sw && se && !nw && !ne) next_[east] = west;
    if (nw && ne && !sw && !se) next_[west] = east;
    if (sw && nw && !se && !ne) next_[south] = north;
    if (se && ne && !sw && !nw) next_[north] = south;
  }

  Vec2 crossing(std::size_t edge) const {
    const bool is_northward = edge % 2 == 1;
    const int column = static_cast<int>(edge / 2 % columns_), row = static_cast<int>(edge / 2 / columns_);
    const int to_column = column + (is_northward ? 0 : 1), to_row = row + (is_northward ? 1 : 0);
    const double a = value(column, row), b = value(to_column, to_row);
    const double share = std::clamp(a / (a - b), kOffPoint, 1 - kOffPoint);
    const Vec2 from = place(column, row), to = place(to_column, to_row);
    return from + (to - from) * share;
  }

  Ring ring_from(std::size_t first) {
    Ring ring;
    for (std::size_t at = first; next_[at] != kNoEdge;) {
      ring.push_back(crossing(at));
      const std::size_t to = next_[at];
      next_[at] = kNoEdge;
      at = to;
    }
    return without_repeats(ring);
  }

  const ValueGrid& grid_;
  int columns_, rows_;
  std::vector<std::uint32_t> next_;
};

}  // namespace

ValueGrid value_grid(double side_m, double step_m, const std::function<double(Vec2)>& value_at) {
  const int cells = static_cast<int>(std::ceil(side_m / step_m));
  const double half_m = cells * step_m / 2;
  ValueGrid grid{{-half_m, -half_m}, step_m, cells + 1, cells + 1, {}};
  grid.values.resize(static_cast<std::size_t>(grid.columns) * grid.rows);
  for_each_index(static_cast<std::size_t>(grid.rows), 0, [&](std::size_t row) {
    double* const values = &grid.values[row * grid.columns];
    for (int column = 0; column < grid.columns; ++column)
      values[column] = value_at(grid.point(column, static_cast<int>(row)));
  });
  return grid;
}

std::vector<Polygon> area_above_zero(const ValueGrid& grid, double least_m2) {
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (Ring& ring : Marching(grid).rings()) {
    const double area_m2 = signed_area_m2(ring);
    if (area_m2 >= least_m2)
      polygons.push_back({std::move(ring), {}});
    else if (area_m2 <= -least_m2)
      holes.push_back(std::move(ring));
  }
  for (Ring& hole : holes) {
    Polygon* smallest = nullptr;
    for (Polygon& polygon : polygons)
      if (box_of(polygon.outer).contains(hole.front()) && winding_number(polygon.outer, hole.front()) != 0 &&
          (!smallest || signed_area_m2(polygon.outer) < signed_area_m2(smallest->outer)))
        smallest = &polygon;
    if (smallest) smallest->holes.push_back(std::move(hole));
  }
  return polygons;
}

}  // namespace citykiln::invent

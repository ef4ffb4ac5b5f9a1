// Values on a square lattice about the middle of the world.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::invent {

/// cells + 1 points on each side, row by row from the south-west corner.
template <typename Value>
struct TownRaster {
  double side_m = 0, step_m = 1;
  int cells = 0;
  std::vector<Value> values;

  TownRaster() = default;
  /// A lattice over a square, with steps of at most step_m.
  TownRaster(double side, double step)
      : side_m(side),
        cells(std::max(1, static_cast<int>(std::ceil(side / step)))),
        values(static_cast<std::size_t>(cells + 1) * static_cast<std::size_t>(cells + 1)) {
    step_m = side / cells;
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells + 1) + static_cast<std::size_t>(column);
  }
  Vec2 place(int column, int row) const { return {column * step_m - side_m / 2, row * step_m - side_m / 2}; }
  /// The column of the point nearest to x; the outermost beyond. row() does the like.
  int column(double x) const { return std::clamp(static_cast<int>((x + side_m / 2) / step_m + 0.5), 0, cells); }
  int row(double y) const { return column(y); }
  Value& nearest(Vec2 p) { return values[index(column(p.x), row(p.y))]; }
  const Value& nearest(Vec2 p) const { return values[index(column(p.x), row(p.y))]; }

  /// The value at a place, bilinear; that of the nearest border outside.
  Value at(Vec2 p) const {
    const double x = std::clamp((p.x + side_m / 2) / step_m, 0.0, cells * 1.0);
    const double y = std::clamp((p.y + side_m / 2) / step_m, 0.0, cells * 1.0);
    const int i = std::min(static_cast<int>(x), cells - 1), j = std::min(static_cast<int>(y), cells - 1);
    const double u = x - i, v = y - j;
    return values[index(i, j)] * ((1 - u) * (1 - v)) + values[index(i + 1, j)] * (u * (1 - v)) +
           values[index(i, j + 1)] * ((1 - u) * v) + values[index(i + 1, j + 1)] * (u * v);
  }
};

}  // namespace citykiln::invent

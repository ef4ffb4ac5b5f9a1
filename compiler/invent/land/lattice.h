// Heights on a square lattice while a terrain is made.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::invent {

/// (cells + 1)² heights in metres above sea level, row by row from the south-west corner, each row from west to east.
struct Lattice {
  int cells = 0;
  double step_m = 0;
  std::vector<double> heights_m;

  int count() const { return cells + 1; }
  std::size_t size() const { return heights_m.size(); }
  int column(std::size_t i) const { return static_cast<int>(i % count()); }
  int row(std::size_t i) const { return static_cast<int>(i / count()); }
  /// Returns the place of a point: metres east and north of the middle of the world.
  Vec2 place(std::size_t i) const {
    const double half_m = cells * step_m / 2;
    return {column(i) * step_m - half_m, row(i) * step_m - half_m};
  }
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * count() + column; }
  bool is_on_border(std::size_t i) const {
    return column(i) == 0 || row(i) == 0 || column(i) == cells || row(i) == cells;
  }
  /// Calls visit(neighbour, distance in steps) for the up to eight neighbours of a point, always in the same order.
  template <typename Visit>
  void for_each_neighbour(std::size_t i, Visit visit) const {
    const int x = column(i), y = row(i);
    if (x > 0 && y > 0 && x < cells && y < cells) return for_each_of_eight(i, visit);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if ((dx != 0 || dy != 0) && x + dx >= 0 && y + dy >= 0 && x + dx <= cells && y + dy <= cells)
          visit(index(x + dx, y + dy), dx != 0 && dy != 0 ? kDiagonal : 1.0);
  }

 private:
  static constexpr double kDiagonal = 1.4142135623730951;

  template <typename Visit>
  void for_each_of_eight(std::size_t i, Visit visit) const {
    const std::size_t n = static_cast<std::size_t>(count());
    visit(i - n - 1, kDiagonal), visit(i - n, 1.0), visit(i - n + 1, kDiagonal);
    visit(i - 1, 1.0), visit(i + 1, 1.0);
    visit(i + n - 1, kDiagonal), visit(i + n, 1.0), visit(i + n + 1, kDiagonal);
  }
};

}  // namespace citykiln::invent

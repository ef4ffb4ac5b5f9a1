// The area where values on a lattice are above a level, as polygons.
#pragma once

#include <functional>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

/// Values on a lattice of (columns × rows) points, row by row from the south-west corner.
struct ValueGrid {
  Vec2 corner;
  double step_m = 0;
  int columns = 0, rows = 0;
  std::vector<double> values;

  Vec2 point(int column, int row) const { return corner + Vec2{column * step_m, row * step_m}; }
  double& at(int column, int row) { return values[static_cast<std::size_t>(row) * columns + column]; }
  double at(int column, int row) const { return values[static_cast<std::size_t>(row) * columns + column]; }
};

/// Returns a grid over a square about the middle of the world, with the value of each point.
/// @param side_m    Rounded up to whole steps.
/// @param value_at  Called from several threads at once.
ValueGrid value_grid(double side_m, double step_m, const std::function<double(Vec2)>& value_at);

/// Returns the area in which the values, linear along the lattice's edges, are above zero, closed along the lattice's
/// border. Method: marching squares; where a square's corners alternate, areas above zero do not touch.
///
/// @param least_m2  Rings of less area are left out.
///
/// Guarantees: rings are simple and share no point; outer rings counter-clockwise, holes clockwise; polygons are in the
/// order of their lowest lattice edge. O(n + rings · holes).
std::vector<Polygon> area_above_zero(const ValueGrid& grid, double least_m2);

}  // namespace citykiln::invent

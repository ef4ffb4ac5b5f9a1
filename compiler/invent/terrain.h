// The ground of an invented world: heights on a square lattice, and the water on it.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

struct River {
  Polyline axis;               ///< Downstream.
  std::vector<double> width_m; ///< One for each point of the axis.
};

/// Heights in metres on (cells + 1)² points, row by row from the south-west corner. The square is about the middle of
/// the world (invented_map.h) and may reach beyond what is mapped.
struct Terrain {
  double side_m = 0;
  int cells = 0;
  std::vector<float> heights_m;
  double sea_level_m = 0;       ///< Ground below it is under the sea.
  std::vector<River> rivers;
  std::vector<Polygon> lakes, sea;

  /// Returns the height at a place, bilinear between the lattice's points; that of the nearest border outside. O(1).
  double height_m(Vec2 p) const;
  /// Returns the gradient of height_m, dimensionless; central differences over one cell.
  Vec2 gradient(Vec2 p) const;
  /// True in the sea, in a lake, or nearer to a river's axis than half its width.
  bool is_water(Vec2 p) const;
};

}  // namespace citykiln::invent

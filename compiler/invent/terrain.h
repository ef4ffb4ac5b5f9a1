// The ground of an invented world: heights on a square lattice, and the water on it.
#pragma once

#include <memory>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

class WaterIndex;

struct River {
  Polyline axis;                ///< Downstream.
  std::vector<double> width_m;  ///< One for each point of the axis.
};

/// Heights in metres on (cells + 1)² points, row by row from the south-west corner. The square is about the middle of
/// the world (invented_map.h) and may reach beyond what is mapped.
struct Terrain {
  double side_m = 0;
  int cells = 0;
  std::vector<float> heights_m;
  double sea_level_m = 0;  ///< Ground below it is under the sea.
  std::vector<River> rivers;
  std::vector<Polygon> lakes, sea;
  std::vector<double> lake_levels_m;              ///< One for each lake.
  std::shared_ptr<const WaterIndex> water_index;  ///< Set by index_water(); without it is_water() looks at all water.

  double step_m() const { return side_m / cells; }
  /// Returns the place of a lattice point.
  Vec2 point(int column, int row) const { return {column * step_m() - side_m / 2, row * step_m() - side_m / 2}; }
  /// Returns the height at a place, bilinear between the lattice's points; that of the nearest border outside. O(1).
  double height_m(Vec2 p) const;
  /// Returns the gradient of height_m, dimensionless; central differences over one cell.
  Vec2 gradient(Vec2 p) const;
  /// True in the sea, in a lake, or nearer to a river's axis than half its width.
  bool is_water(Vec2 p) const;
};

/// Makes is_water() fast: it then looks only at water near the place. To be called again when water changes.
void index_water(Terrain& terrain);

}  // namespace citykiln::invent

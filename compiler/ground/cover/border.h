// Borders: edges between land cover faces.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/triangles/delaunay.h"

namespace citykiln::ground {

/// A piece of a visible border, and the indices of the polygons to its left and right, seen from a to b. The cell's own
/// border has the polygon inside the cell on both sides. Points are on the plane's grid of kQuantum_m.
struct Border {
  GridPoint a, b;  ///< a < b
  std::uint32_t left = 0, right = 0;
  bool is_cell_border = false;
  bool operator==(const Border&) const = default;
};

/// Orders borders by place.
inline bool is_before(const Border& one, const Border& other) {
  return std::tie(one.a, one.b) < std::tie(other.a, other.b);
}

/// Returns the ends of borders, sorted, without repeats.
std::vector<GridPoint> ends_of(std::span<const Border> borders);

/// Returns the ends of edge i, 0 to 2, of a triangulation's face. The face lies to the left of the edge.
inline std::pair<GridPoint, GridPoint> edge_of(const Delaunay& net, std::uint32_t face, int i) {
  const auto& v = net.faces()[face].vertices;
  return {net.vertices()[v[(i + 1) % 3]], net.vertices()[v[(i + 2) % 3]]};
}

/// True if a point of the cell lies on the cell's border.
inline bool is_on_border(GridPoint p, const Box2& cell) {
  const GridPoint min = grid_point(cell.min), max = grid_point(cell.max);
  return p.x == min.x || p.x == max.x || p.y == min.y || p.y == max.y;
}

/// A piece of the cell's border along which a polygon's ring runs, so that the polygon on top beyond the border may be
/// another one than inside. Most pieces are a few grid steps long: snapping has moved a ring near the border onto it.
struct CellBorderPiece {
  GridPoint a, b;            ///< a < b
  std::uint32_t beyond = 0;  ///< The polygon on top in the neighbouring cell.
  bool operator==(const CellBorderPiece&) const = default;
};

/// One tolerance per side of a cell. Both cells of a side must use the same.
struct SideTolerances {
  double west_m, east_m, south_m, north_m;
};
inline SideTolerances all_sides(double m) { return {m, m, m, m}; }

/// Returns the tolerance of the side of the cell on which a border with is_cell_border lies.
double tolerance_m_of(const SideTolerances& sides, const Border& border, const Box2& cell);

}  // namespace citykiln::ground

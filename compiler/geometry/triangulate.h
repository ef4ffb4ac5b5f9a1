// Polygons with holes as triangles, whatever their rings do.
#pragma once

#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Triangles of the plane that share points.
struct PlaneTriangles {
  std::vector<Vec2> points;  ///< The outer ring's, then each hole's, in order; then points where rings cross, snapped.
  std::vector<Triangle> triangles;  ///< Counter-clockwise, area > 0. Of points in one place the first is used.
};

/// What lies inside of an odd number of rings, as a constrained Delaunay triangulation.
///
/// Guarantees: where rings do not cross or touch, the triangles' points are the rings' and their area is the polygon's.
/// The same bytes for the same polygon. Total: rings may cross themselves and each other, overlap, repeat points, have
/// no area; what lies inside then goes by the even-odd rule, and crossings become points. O(n log n) and, per region
/// that the rings enclose, O(n). Method: CGAL's constrained Delaunay triangulation; each region between constraints is
/// tested at the middle of its largest triangle.
PlaneTriangles triangulate(const Polygon& polygon);

}  // namespace citykiln

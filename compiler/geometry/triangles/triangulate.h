// Triangulates polygons with holes, valid or not.
#pragma once

#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Triangles in the plane with shared points.
struct PlaneTriangles {
  std::vector<Vec2> points;  ///< Points of the outer ring, of each hole in order, then crossings of rings, snapped.
  std::vector<Triangle> triangles;  ///< Counter-clockwise, area > 0. They use the first of coincident points.
};

/// Triangulates the area inside an odd number of rings.
///
/// Guarantees: if rings do not cross or touch, the triangles have the rings' points and the polygon's area.
/// Deterministic. Cannot fail: rings may cross themselves and each other, overlap, repeat points or have no area; the
/// inside then follows the even-odd rule and crossings become points. O(n log n), and O(n) for each face of the rings'
/// arrangement. Method: CGAL's constrained Delaunay triangulation; each area between constraints is tested at the
/// centroid of its largest triangle.
PlaneTriangles triangulate(const Polygon& polygon);

}  // namespace citykiln

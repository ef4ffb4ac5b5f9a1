// Triangulates polygons with holes, valid or not.
#pragma once

#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Triangles in the plane with shared points.
struct PlaneTriangles {
  std::vector<Vec2> points;  ///< Those of the outer ring, of each hole in order, then crossings of rings, snapped.
  std::vector<Triangle> triangles;  ///< Counter-clockwise, area > 0. Of coincident points the first is used.
};

/// Triangulates the area inside an odd number of rings.
///
/// Guarantees: if rings do not cross or touch, the triangles have the rings' points and the polygon's area.
/// Deterministic. Cannot fail: rings may cross themselves and each other, overlap, repeat points or have no area; the
/// inside then follows the even-odd rule and crossings become points. O(n log n), and O(n) for each region enclosed by
/// the rings. Method: CGAL's constrained Delaunay triangulation; each region between constraints is tested at the
/// middle of its largest triangle.
PlaneTriangles triangulate(const Polygon& polygon);

}  // namespace citykiln

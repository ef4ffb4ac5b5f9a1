// Rings, polygons and polylines of the plane. Outer rings run counter-clockwise, holes clockwise; the last point is not
// repeated.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln {

using Polyline = std::vector<Vec2>;
using Ring = std::vector<Vec2>;

struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
  bool operator==(const Polygon&) const = default;
};

/// Returns the outer ring, then the holes, as pointers into the polygon.
std::vector<const Ring*> rings_of(const Polygon& polygon);

/// Returns the area of a ring, square metres; positive if it runs counter-clockwise. O(n).
double signed_area_m2(std::span<const Vec2> ring);
/// Returns the area of the outer ring minus the area of the holes, square metres.
double area_m2(const Polygon& polygon);
/// Returns the length of a polyline in metres.
double length_m(std::span<const Vec2> polyline);

/// Returns the winding number of the ring about p, positive if counter-clockwise. A point on the ring may count as
/// inside or outside. Sign tests are exact for points on the plane's grid within 64 km of each other. O(n).
int winding_number(std::span<const Vec2> ring, Vec2 p);
/// True if p is inside an odd number of rings.
bool contains(const Polygon& polygon, Vec2 p);

/// Returns the ring without consecutive equal points (last and first included) and without spikes: edges that double
/// back on the edge before.
Ring without_repeats(std::span<const Vec2> ring);

/// Returns the ring without those vertices outside a box that can be dropped such that every edge which touches the box
/// stays and every point in the box keeps its winding number. The result is empty if the ring's bounding box does not
/// touch the box. O(n).
Ring trimmed_to(std::span<const Vec2> ring, const Box2& box);

}  // namespace citykiln

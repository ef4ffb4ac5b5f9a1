// Cuts areas by straight lines. An area is a list of rings: outer rings counter-clockwise, holes
// clockwise, in plane metres. A place is in the area if the winding numbers of the rings add up to
// more than 0. A line is given by a point `at` and a direction `along`.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::fields {

/// Returns the rings of the part of an area to the left of a line; empty if there is none. `along`
/// may have any length but 0. Rings may touch themselves along the line. New points are multiples
/// of map::kMapStep_m; the other side (along * -1) has the same ones. O(n). Source: Sutherland,
/// Hodgman, "Reentrant polygon clipping", Comm. ACM 17 (1974).
std::vector<Ring> left_of_cut(std::span<const Ring> rings, Vec2 at, Vec2 along);

/// Returns the parts of a line that are inside an area, in the order along it, as pairs of points
/// on multiples of map::kMapStep_m. `along` must be a unit vector, and rings must not overlap.
/// O(n log n).
std::vector<std::pair<Vec2, Vec2>> inside_parts(std::span<const Ring> rings, Vec2 at, Vec2 along);

/// Returns the area inside the rings, m²: holes count as negative.
double area_of(std::span<const Ring> rings);

/// Returns a polygon with its points rounded to multiples of map::kMapStep_m, as mapped points are,
/// without repeated points and holes of fewer than three. A single point between these steps would
/// make all points of its tile need more bytes.
Polygon on_map_steps(const Polygon& polygon);

/// Returns rectangles that together cover all places within half_m of a line: one for each segment,
/// which reaches half_m beyond both of its ends. Corners are rounded to 1/8 m. Neighbours overlap.
/// O(n).
std::vector<Ring> strip_about(const Polyline& line, double half_m);

}  // namespace citykiln::fields

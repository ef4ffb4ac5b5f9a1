// Cuts areas that are given as rings by straight lines. A place is in the area if the winding numbers of the rings add
// up to more than zero.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::fields {

/// Returns the rings of the part of an area to the left of a line; empty if there is none. Rings may touch themselves
/// along the line. New points are multiples of map::kMapStep_m, and both sides of a line (along, along * -1) have the
/// same ones. O(n). Source: Sutherland, Hodgman, "Reentrant polygon clipping", Comm. ACM 17 (1974).
std::vector<Ring> left_of_cut(std::span<const Ring> rings, Vec2 at, Vec2 along);

/// Returns the parts of a line that are in an area, by place along it. O(n log n).
std::vector<std::pair<Vec2, Vec2>> inside_parts(std::span<const Ring> rings, Vec2 at, Vec2 along);

/// Returns the sum of the areas of rings, m².
double area_of(std::span<const Ring> rings);

/// Returns a polygon with its points on multiples of map::kMapStep_m, as mapped ones are. One point between them would
/// make all points of its tile need more bytes.
Polygon on_map_steps(const Polygon& polygon);

/// Returns rings that together cover the strip of this half width about a line, one for each segment. Corners are
/// multiples of 1/8 m. Neighbours overlap. O(n).
std::vector<Ring> strip_about(const Polyline& line, double half_m);

}  // namespace citykiln::fields

// Clips polylines to boxes.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Returns the parts of a polyline in a box, in its order. A closed polyline whose begin lies in the box is cut only
/// where it crosses a side.
///
/// @param box     Corners on the grid.
/// @param step_m  The grid of the points, a power of two.
///
/// Guarantees: each part has at least two points and no repeated neighbours; a polyline inside stays unchanged; new
/// points lie exactly on a side, and within a step of the polyline. O(n). Source: Liang, Barsky (1984).
std::vector<Polyline> clipped_to(const Polyline& polyline, const Box2& box, double step_m);

}  // namespace citykiln

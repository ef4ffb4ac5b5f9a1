// Clips polylines to boxes.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Returns the parts of a polyline that lie in a box, in order along it; empty if none does. A closed polyline (its
/// first point is repeated at the end) whose first point lies in the box is not cut there: the part through it comes
/// first.
///
/// @param box     Corners on the grid of step_m.
/// @param step_m  Grid step of the points, a power of two, in metres.
///
/// Guarantees: each part has at least two points and no equal consecutive points; a polyline inside the box is returned
/// unchanged; new points lie exactly on a side, and within a step of the polyline. O(n). Source: Liang, Barsky (1984).
std::vector<Polyline> clipped_to(const Polyline& polyline, const Box2& box, double step_m);

}  // namespace citykiln

// Curves of roads: lattice paths made smooth.
#pragma once

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

/// Returns the points of a polyline without those that lie within `within_m` of the line without them
/// (Douglas and Peucker 1973).
Polyline simplified_path(const Polyline& path, double within_m);

/// Returns a smooth curve along a polyline, with its ends, by cutting corners (Chaikin 1974) `times` times.
Polyline without_corners(const Polyline& path, int times);

/// Returns points at even distances of about step_m along a polyline, with its ends.
Polyline with_even_steps(const Polyline& path, double step_m);

}  // namespace citykiln::invent

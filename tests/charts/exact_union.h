// Polygon union with exact constructions by CGAL: slow, for comparison.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::charts {

/// Returns the union of counter-clockwise simple rings. Vertices are computed exactly, then rounded to multiples of
/// `step_m`, which may make polygons invalid. Rings that are not simple are left out. Cost: some milliseconds for a
/// dozen rings.
std::vector<Polygon> exact_union(std::span<const Ring> rings, double step_m);

}  // namespace citykiln::charts

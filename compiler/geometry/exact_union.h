// A union with exact constructions, by CGAL: slow, and right until it is written in numbers of fixed size. For charts
// and tests.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// The union of counter-clockwise simple rings; vertices exact while it is made, then rounded to the nearest multiple
/// of `step_m`: what rounding does to them is the caller's to look at. Rings that are not simple are left out. Cost:
/// some milliseconds a dozen rings.
std::vector<Polygon> exact_union(std::span<const Ring> rings, double step_m);

}  // namespace citykiln

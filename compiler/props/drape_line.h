// Drapes polylines over the ground.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::props {

/// Returns a polyline on the graded ground. Points are added where it crosses an edge of the terrain's grid, and every
/// 2 m on graded ground.
///
/// Guarantees: all points of the polyline are kept; consecutive points differ in plan; points are snapped, so they are
/// at most 2^-10 m times (1 + slope) off the ground. Outside of the terrain no points are added. O(length / step).
std::vector<Vec3> drape_line(const Polyline& line, const ground::GradedTerrain& ground);

}  // namespace citykiln::props

// A line in plan laid onto the ground.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/ground/grading/graded_terrain.h"

namespace citykiln::props {

/// The polyline on the graded terrain, with a point wherever it crosses an edge of the terrain's grid, and every two
/// metres where the ground is carved.
///
/// Guarantees: begins and ends where the polyline does; keeps its points; no two neighbours in one place in plan;
/// snapped, so off the ground by no more than 2^-10 m times one and the steepness. Outside the field no points are
/// added. O(length / step).
std::vector<Vec3> drape_line(const Polyline& line, const ground::GradedTerrain& ground);

}  // namespace citykiln::props

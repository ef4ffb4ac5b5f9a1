// A line in plan laid onto the ground.
#pragma once

#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/map/heightfield.h"

namespace citykiln::props {

/// The polyline on the heightfield, with a point wherever it crosses an edge of the field, so that it lies on the
/// ground all along.
///
/// Guarantees: begins and ends where the polyline does; keeps its points; no two neighbours in one place in plan;
/// snapped, so off the ground by no more than 2^-10 m times one and the steepness. Outside the field no points are
/// added. O(length / step).
std::vector<Vec3> follow_ground(const Polyline& line, const map::Heightfield& heights);

}  // namespace citykiln::props

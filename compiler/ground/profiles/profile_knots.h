// Profiles from heights by node, with as few knots as possible.
#pragma once

#include <span>

#include "compiler/geometry/profile.h"
#include "compiler/ground/profiles/junction_planes.h"

namespace citykiln::ground {

/// Largest error of a profile against its stations' heights, and against their tilts at kTiltArm_m off the axis.
inline constexpr double kKnotError_m = 0.01;
inline constexpr double kTiltArm_m = 8;

/// Returns the profile of a way by Douglas and Peucker (1973). Guarantees: a knot at both ends, where ways share a
/// node, and at each multiple of kKnotStretch_m; knots rise strictly along the way, on the grids of profile.h; the
/// first at 0, the last at most 1/8 m before the way's end. O(n log n) as a rule.
Profile knots_of(const ProfileGraph& graph, const GraphWay& way, const JunctionPlanes& planes);

}  // namespace citykiln::ground

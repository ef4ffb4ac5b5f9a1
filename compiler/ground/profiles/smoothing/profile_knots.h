// Makes profiles from heights by node. A knot is a point of a profile: height and tilt at a distance along the way;
// profiles are linear between knots, of which there are few.
#pragma once

#include <span>

#include "compiler/geometry/profile.h"
#include "compiler/ground/profiles/smoothing/junction_planes.h"

namespace citykiln::ground {

/// The largest error of a profile against the heights of its stations, on the axis and, as a measure of tilt, at a
/// distance of kTiltArm_m from it.
inline constexpr double kKnotError_m = 0.01;
inline constexpr double kTiltArm_m = 8;

/// Returns the profile of a way by Douglas and Peucker (1973).
/// @param planes  Heights and tilts by node.
/// Guarantees: there is a knot at both ends, at nodes that several ways share, and at each multiple of kKnotStretch_m;
/// at_m increases strictly, on the grids of profile.h; the first knot is at 0, the last one at most 1/8 m before the
/// way's end. O(n log n) as a rule.
Profile knots_of(const ProfileGraph& graph, const GraphWay& way, const JunctionPlanes& planes);

}  // namespace citykiln::ground

// Heights by node, written down as profiles: as few knots as say it.
#pragma once

#include <span>

#include "compiler/geometry/profile.h"
#include "compiler/ground/profiles/junction_planes.h"

namespace citykiln::ground {

/// A profile is nowhere farther than this from its stations' heights, nor from their tilts at kTiltArm_m off the axis.
inline constexpr double kKnotError_m = 0.01;
inline constexpr double kTiltArm_m = 8;

/// The profile of a way. Where ways share a node, and at both ends, there is a knot. Guarantees: knots rise strictly
/// along the way, on the grids of profile.h; the first lies at 0, the last at the way's end or less than 1/8 m before.
/// Douglas and Peucker (1973). O(n log n) as a rule.
Profile knots_of(const ProfileGraph& graph, const GraphWay& way, const JunctionPlanes& planes);

}  // namespace citykiln::ground

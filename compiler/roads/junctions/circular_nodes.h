// Circular nodes: mini roundabouts and turning circles.
#pragma once

#include <span>

#include "compiler/roads/network.h"

namespace citykiln::roads {

/// Returns the radius of the disk about the node that these arms leave, by the track points of their roads: 5 m for a
/// mini roundabout, 6 m for a turning circle, and at least 1.5 m more than half the widest arm, but at most 12 m. 0:
/// not circular. O(arms).
double disk_radius_m(std::span<const Road> roads, std::span<const Arm> arms);

}  // namespace citykiln::roads

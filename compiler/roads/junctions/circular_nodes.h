// Places that are round: mini roundabouts, and circles to turn in at the end of a street or along it.
#pragma once

#include <span>

#include "compiler/roads/network.h"

namespace citykiln::roads {

/// The radius of the disk about the place that these arms leave, as the points of their roads tell it: 5 m for a mini
/// roundabout, 6 m for a turning circle, and 1.5 m more than the widest arm's half, but at most 12 m. 0: not round.
/// O(arms).
double disk_radius_m(std::span<const Road> roads, std::span<const Arm> arms);

}  // namespace citykiln::roads

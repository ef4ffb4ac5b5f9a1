// Roads whose lanes and markings run through a junction.
#pragma once

#include <span>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// True if the lanes and lines of a road continue across the junction and hide its surface. The junction is one of
/// streets with one node, at least three arms (roads that leave it), no signals and no disk (disk_radius_m()). Exactly
/// two arms have the highest class; they turn by less than 37 degrees, and their kerbs are equally far from the axis,
/// within 0.25 m on each side.
///
/// @param arms  The entry of arms_of() for this junction.
bool has_through_road(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

}  // namespace citykiln::roads

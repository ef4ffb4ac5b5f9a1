// Roads that go on through a junction as if nothing were there.
#pragma once

#include <span>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// Whether one road, of two arms, goes on through the junction and all others are lesser and have no signals: its lanes
/// and lines go on across, and those of the junction that it covers are not seen.
///
/// @param arms  Of the junction, as arms_of() has them.
bool has_through_road(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

}  // namespace citykiln::roads

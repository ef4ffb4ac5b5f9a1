// Whether something holds up what min_height lifts off the ground. Where the storeys below are not mapped, or a clip
// has taken them away, whole blocks would hover.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::buildings {

/// A footprint is held up by what lies under some of it and reaches up to it; or, if it is no larger than a bridge
/// between houses or a bay, by any wall that it is joined to. Over roads and paths everything may hover: passages and
/// halls on columns are mapped so, and so may roofs, and what is higher up than a base. Outlines that parts replace
/// hold nothing.
///
/// One a footprint; true for those on the ground. Looked at in 16 by 16 places of each. O(n) for footprints that lie
/// apart.
std::vector<bool> find_supported(std::span<const map::Footprint> footprints, std::span<const map::Track> tracks);

}  // namespace citykiln::buildings

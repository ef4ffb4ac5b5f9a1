// The uses of grounds that a map may have.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/things/yard_kinds.h"

namespace citykiln::vacant {

/// Returns the uses that yards and plots on these areas may have: those of any town, and those of each mapped land use.
/// A manifest has rules only for things of these uses; things of other uses are not drawn. O(n).
std::vector<things::YardUse> uses_on(std::span<const map::AreaFeature> areas);

}  // namespace citykiln::vacant

// The uses of grounds that a map may have.
#pragma once

#include <span>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/things/yard_kinds.h"

namespace citykiln::vacant {

/// Returns the uses of yards and plots on these areas: those of towns, and those of the land uses that are mapped.
/// Things of other uses are not drawn, so that a manifest holds no rules for them. O(n).
std::vector<things::YardUse> uses_on(std::span<const map::AreaFeature> areas);

}  // namespace citykiln::vacant

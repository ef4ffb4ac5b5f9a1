// Finds the building outline to which each building:part belongs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

inline constexpr std::uint32_t kNoOutline = ~0u;

/// Returns for each part the index of its building's outline among the footprints: the smallest outline that contains
/// the centroid of the part's largest triangle; on a tie the one with the lowest id. kNoOutline for outlines, and for
/// parts outside of all outlines. Which outline is found does not depend on the order of the footprints. O(n) for
/// outlines that do not overlap.
std::vector<std::uint32_t> part_outlines(std::span<const Footprint> footprints);

}  // namespace citykiln::map

// Outlines of building parts: which building each building:part belongs to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

inline constexpr std::uint32_t kNoOutline = ~0u;

/// Returns for each footprint the index of the outline it belongs to: for a part the smallest outline (then the one of
/// the lowest id) that contains the centre of the part's largest triangle. kNoOutline for outlines, and for parts
/// outside of all outlines. Apart from indices the result does not depend on the order of the footprints. Total. O(n)
/// for outlines that do not overlap.
std::vector<std::uint32_t> part_outlines(std::span<const Footprint> footprints);

}  // namespace citykiln::map

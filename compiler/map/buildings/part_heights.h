// Completes the heights of building parts by those of their building.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Completes the parts of outlines. A part without height and levels has the outline's, if its min_height leaves room.
/// Storeys of a part, and below it, are as high as the outline's: by its height and levels, else by those of the part,
/// else by the outline's class.
/// @param outlines  part_outlines() of the footprints.
void complete_parts(std::vector<Footprint>& footprints, std::span<const std::uint32_t> outlines);

/// Returns the height of a storey by height=* and building:levels=*; 0 if one of them is not tagged, or if they
/// contradict each other.
double measured_storey_m(const Footprint& footprint);

}  // namespace citykiln::map

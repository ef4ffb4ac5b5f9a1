// Completes the heights of building parts (building:part=*) by those of the outline of their building.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Completes the heights of all parts that have an outline, except steps. O(n).
///
/// - A part without height and levels takes the outline's, if they are above the part's min_height.
/// - A part with levels gets its heights in metres from them. A storey is as high as the height and levels of the
///   outline say, else those of the part, else the outline's class.
/// - A part that would then end below its min_height keeps the heights that were read.
/// @param outlines  part_outlines() of the footprints.
void complete_parts(std::vector<Footprint>& footprints, std::span<const std::uint32_t> outlines);

/// Returns the height of a storey: height=* without the roof, divided by building:levels=*. 0 if one of them is not
/// tagged, or if they contradict each other: a storey would be lower than 2.1 m or higher than 7 m.
double measured_storey_m(const Footprint& footprint);

}  // namespace citykiln::map

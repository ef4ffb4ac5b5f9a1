// Divides steps that are mapped as an area (building:part=steps) into treads.
//
//              __
//           __|      each tread is a footprint of its own, with a level top
//     roof |         down the roof:direction
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Replaces footprints of steps by their treads, which are counted as split.
///
/// They rise by roof:height, else by the whole height; without both, as far as steps of usual form do on their length.
/// They descend in roof:direction, else away from the middle of their outline, at right angles to an edge. The result
/// does not depend on the order of the footprints.
/// @param outlines  part_outlines() of the first footprints; those after them are no steps.
std::vector<Footprint> with_treads(std::vector<Footprint> footprints, std::span<const std::uint32_t> outlines,
                                   Account& account, Report& report);

}  // namespace citykiln::map

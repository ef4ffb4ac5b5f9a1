// Divides steps that are mapped as an area (building:part=steps) into treads, the level tops of single steps.
//
//              __
//           __|      each tread is a footprint of its own, with a level top
//     roof |         they descend in the direction of roof:direction
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Replaces footprints of steps by their treads. Added footprints count as split in `account`.
///
/// The treads rise by roof:height, else by the whole height; if neither is tagged, by 0.17 m per 0.3 m of length. They
/// descend in roof:direction, else at right angles to the edge that faces away from the middle of the building's
/// outline. There are at most 100, each at least 0.125 m deep. The result does not depend on the order of the
/// footprints.
/// @param outlines  part_outlines() of the first footprints. Later footprints stay unchanged.
/// @param report    Decides which objects are counted.
std::vector<Footprint> with_treads(std::vector<Footprint> footprints, std::span<const std::uint32_t> outlines,
                                   Account& account, Report& report);

}  // namespace citykiln::map

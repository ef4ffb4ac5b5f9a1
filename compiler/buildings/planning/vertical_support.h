// Finds the vertical support of buildings that min_height lifts off the ground. If the storeys below are not mapped, or
// lie outside the extract, such a building would float.
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/planning/party_walls.h"
#include "compiler/map/features.h"

namespace citykiln::buildings {

/// Returns true for each footprint that is supported.
///
/// Supported are footprints on the ground; footprints above others that reach up to them within 3.5 m (a storey), at
/// more than 2 % of 16 by 16 sample points, or above the middle of one of these, which may be a column; bays (under 150
/// m²) that share a wall with a footprint of their height, and bridges that share walls with two. Outlines with parts
/// support nothing. O(n) for footprints that do not overlap.
/// @param shared  The result of shared_walls(footprints).
std::vector<bool> find_supported(std::span<const map::Footprint> footprints,
                                 std::span<const std::vector<SharedWall>> shared);

}  // namespace citykiln::buildings

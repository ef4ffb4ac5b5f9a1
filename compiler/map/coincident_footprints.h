// Footprints that would be built in the same place: duplicates, and parts inside an outline that is built too.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Leaves out footprints whose outline coincides with that of another one, both outlines or both parts, between nearly
/// the same heights. Kept are those with tagged heights, then the tallest, then those of the lowest ids. Parts above
/// each other stay.
///
/// Outlines coincide where every corner of each lies within kSameOutline_m of the other's border. Dropped:
/// kDuplicateBuilding. The result does not depend on the order of the footprints. O(n) for outlines that do not
/// overlap, times their corners squared.
std::vector<Footprint> without_duplicates(std::vector<Footprint> footprints, Account& account, Report& report);

/// Mends the parts of outlines that are built too (has_parts is false): a part that lies within the heights of its
/// outline is left out, kDuplicateBuilding; one that is higher begins at the outline's eaves. Total. O(n).
std::vector<Footprint> without_enclosed_parts(std::vector<Footprint> footprints, Account& account, Report& report);

inline constexpr double kSameOutline_m = 0.5;

}  // namespace citykiln::map

// Drops footprints that would be built in the same place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Drops duplicates, kDuplicateBuilding. Two building outlines, or two parts, are duplicates if their polygons coincide
/// and they share more than half the height of the lower one; parts above each other stay. The one with tagged height
/// or levels is kept, then the taller one, then the one with the lower id.
///
/// Polygons coincide if every corner of each lies within kSameOutline_m of the other's border. The result does not
/// depend on the order of the footprints. O(n) for outlines that do not overlap, times their corners squared.
std::vector<Footprint> without_duplicates(std::vector<Footprint> footprints, Account& account, Report& report);

/// The largest distance between two outlines that coincide.
inline constexpr double kSameOutline_m = 0.5;

}  // namespace citykiln::map

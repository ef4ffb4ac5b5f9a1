// Adds shop fronts: one for each shop that is mapped as a point, and assumed ones along streets in town centres where
// no shop is mapped.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The fronts of a map, mapped and assumed, sorted by FrontPoint::id, then by position; and the indices of the
/// footprints that have assumed ones.
struct AssumedFronts {
  std::vector<map::FrontPoint> fronts;
  std::vector<std::uint32_t> footprints;
};

/// Returns all fronts, mapped and assumed. Without this function no building has fronts, not even those of mapped
/// points.
///
/// Every point of a shop, restaurant, office or workshop gets a front, which buildings/planning/fronts.h places if
/// there is room. The map states that the shop exists; width, door and colours of its front are assumed.
///
/// A wall may get assumed fronts if no shop is mapped within kFrontSearch_m of its middle, its building touches another
/// one and has at least kFrontStoreys storeys, and the kerb of a street that it faces is at most kFrontKerb_m away. A
/// random share of these walls gets fronts, by country group and class of street (fronts.inc). The number of fronts is
/// the length of the wall divided by kWallPerFront_m, rounded, at least 1.
///
/// The result for a wall depends on the footprints that touch its building, the streets within kFrontKerb_m, the shops
/// within kFrontSearch_m, and on assumed storeys (assume_heights()). Cannot fail. O(n · edges near), n: walls.
///
/// @param report  Counts each footprint with assumed fronts as Assumption::kFronts.
AssumedFronts assume_fronts(const map::FeatureView& features, std::uint64_t seed, Report& report);

/// No front is assumed this near to a shop that is mapped as a point or as an outline.
inline constexpr double kFrontSearch_m = 150;
/// The largest distance from the middle of a wall to the kerb of its street.
inline constexpr double kFrontKerb_m = 6;
/// The least number of storeys of a building with assumed fronts, and its least height if its storeys are unknown.
inline constexpr double kFrontStoreys = 3, kFrontHeight_m = 8.5;
/// The length of wall for each assumed front. On walls with mapped shops, the median length for each shop is 14 m in
/// Helsinki, 9 m in Nice, 15 m in Monaco.
inline constexpr double kWallPerFront_m = 12;

}  // namespace citykiln::assume

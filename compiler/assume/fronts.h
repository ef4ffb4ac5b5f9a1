// Fronts of shops: those that are mapped as points, and assumed ones along streets of centres without any.
#pragma once

#include <cstdint>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Sets Features::fronts.
///
/// Every point of a shop, restaurant, office or workshop has a front (buildings/fronts.h places it): the map says that
/// it is there, its width, door and colours are assumed.
///
/// Without a shop within kFrontSearch_m, walls of attached houses of at least kFrontStoreys storeys whose neighbouring
/// street is no farther than kFrontKerb_m get fronts, in a share of the walls by country group and class of street
/// (fronts.inc). A wall has one front for each kAssumedFront_m. Decisions are made for each wall, from the footprints
/// that touch it, the streets within kFrontKerb_m, and the shops within kFrontSearch_m. O(edges near).
void assume_fronts(map::Features& features, std::uint64_t seed, Report& report);

/// No front is assumed this near to a shop that is mapped as a point or as an outline.
inline constexpr double kFrontSearch_m = 150;
/// The largest distance of a wall from the kerb of its street.
inline constexpr double kFrontKerb_m = 6;
/// The least number of storeys, and the least height of walls whose storeys are unknown.
inline constexpr double kFrontStoreys = 3, kFrontHeight_m = 8.5;
/// The usual width of a front.
inline constexpr double kAssumedFront_m = 7.5;

}  // namespace citykiln::assume

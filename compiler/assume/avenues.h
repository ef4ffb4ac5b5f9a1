// Assumes trees along roads outside of towns.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/lonlat.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns longitude and latitude of a point of the plane, in metres.
using LonLatOf = std::function<LonLat(Vec2)>;

/// The distance in metres from a road's axis within which a mapped tree, or row of trees, leaves no
/// trees to be assumed beside the stretch.
inline constexpr double kMappedTrees_m = 15;

/// Returns all tracks, in order; ways of more than kLongestWhole_m (pavements.h) that may have an
/// avenue are cut into stretches. Stretches with an avenue have Track::trees and Track::tree_kind.
///
/// A stretch may have an avenue if it lies on the ground, starts in a region of avenues.inc, and
/// its class has a row there; links and roundabouts have none. The way's id and `seed` draw whether
/// it has one, and the species. A stretch has none if it is shorter than 60 m, if its trees are
/// tagged, or if trees are mapped within kMappedTrees_m of its axis.
///
/// A side has trees if most of the land beside it is farmland or has no mapped use, if buildings
/// stand along less than a tenth of either side, and if the free room beyond the kerb is at least
/// kAvenueRoom_m. These tests keep avenues out of towns.
///
/// Each way with an avenue is counted once in the report as Assumption::kRoadsides. Radius of
/// influence: kPavementRadius_m (pavements.h). O(n log n), n: mapped points.
std::vector<map::Track> assume_avenues(const map::FeatureView& features, const LonLatOf& lonlat_of, std::uint64_t seed,
                                       Report& report);

/// The least free room beyond the kerb for a row of trees, in metres.
inline constexpr double kAvenueRoom_m = 2.5;

}  // namespace citykiln::assume

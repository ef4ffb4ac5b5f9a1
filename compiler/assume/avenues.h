// Assumes trees along roads outside of towns.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/lonlat.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns the place of a point of the plane.
using LonLatOf = std::function<LonLat(Vec2)>;

/// Trees that are mapped within this distance of a road leave none to be assumed beside it, in metres.
inline constexpr double kMappedTrees_m = 15;

/// Returns the tracks with Track::trees and Track::tree_kind of roads that have avenues, by avenues.inc: stretches on
/// the ground outside of towns, in regions and of classes with a row, drawn by the way's id.
///
/// A side has trees where its land is farmland or of no use, buildings stand along less than a tenth of it, and the
/// room beside the kerb is kAvenueRoom_m. A stretch has none where trees are mapped within kMappedTrees_m of it, or
/// tagged. Counted in the report as Assumption::kRoadsides. Radius: kPavementRadius_m (pavements.h). O(n log n).
std::vector<map::Track> assume_avenues(const map::FeatureView& features, const LonLatOf& lonlat_of, std::uint64_t seed,
                                       Report& report);

/// The room that trees need beside the kerb, in metres.
inline constexpr double kAvenueRoom_m = 2.5;

}  // namespace citykiln::assume

// Assumes rows of parked cars on carriageways whose tagged width is greater than the moving lanes need.
//
//     houses   [###] [###]      width=10, two lanes, no parking=*: parking.inc gives the width that a moving lane keeps
//     kerb     =============    in a country group; if 4 m are left, a row of 2 m is beside both kerbs; if only 2 m are
//     parked   ##  ##  ##  #    left, beside the right kerb where traffic drives on the right, else the left one
//     lane     -------------
//
// A side has a row only if buildings stand along more than a quarter of it, and its land use is residential, shops or
// not mapped.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The width of a row of cars parked along the kerb: the default of parking=lane.
inline constexpr double kParkedRow_m = 2;

/// Returns the tracks with assumed rows of parked cars, sorted by id. The rows are the same lanes as parking:left=lane
/// and parking:right=lane give. The moving lanes become narrower, the carriageway keeps its width. A street may change
/// if it lies on the ground, its width is tagged, and no tag says for any of its sides whether cars park there
/// (Track::tagged_parking). Ways of more than kLongestWhole_m are cut as by assume_pavements(). The radius is
/// kPavementRadius_m (pavements.h). O(n log n), n: points of all features.
std::vector<map::Track> assume_parking(const map::FeatureView& features, Report& report);

}  // namespace citykiln::assume

// Assumes rows of parked cars on carriageways that are tagged as wider than their traffic needs.
//
//     houses   [###] [###]      width=10 and two lanes, no parking=*: a row of parking.inc says how wide the moving
//     kerb     =============    lanes stay in a country; what is left holds a row of 2 m beside the kerb on both sides,
//     parked   ##  ##  ##  #    or on the side of traffic alone. Only beside houses, shops or residential land.
//     lane     -------------
#pragma once

#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The width of a row of cars parked along the kerb: the default of parking=lane.
inline constexpr double kParkedRow_m = 2;

/// Returns the sides of a street, as bits of RoadSide, on which cars are assumed to park; 0 if the street may not have
/// any or is too narrow.
std::uint8_t assumed_parking(const map::Track& stretch, const BothSides& facts);

/// Returns the tracks with assumed rows of parked cars, sorted by id: the lanes that parking:left=lane and
/// parking:right=lane give. They take their width from the moving lanes. Streets on the ground with a tagged width
/// change where no tag says whether cars park on either side (Track::tagged_parking). Longer ways are cut as by
/// assume_pavements(), and what decides lies within kPavementRadius_m. The order of features does not matter.
/// O(n log n).
std::vector<map::Track> assume_parking(const map::Features& features, Report& report);

}  // namespace citykiln::assume

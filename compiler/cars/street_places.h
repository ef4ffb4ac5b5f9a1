// Parking places along streets.
//
//     ______________ pavement ______________
//      [ car ] [ car ] [     ] [ car ]           in a parking lane, or at the kerb: every 5.75 m along the way
//     - - - - - - - - - - - - - - - - - - - ►    axis
//
//     ___________ carriageway ______________
//      |c| |c| | | |c| |c|                       on a car park beside it: across, every 2.5 m, or along it
#pragma once

#include <span>
#include <vector>

#include "compiler/cars/place.h"
#include "compiler/roads/recipe.h"

namespace citykiln::cars {

/// The length of a place along a kerb, and its width where cars stand side by side. EAR 05: 5.7 m, and 5.2 m at the
/// ends of a row; 2.5 m.
inline constexpr double kKerbPlace_m = 5.75, kAcross_m = 2.5;
/// The width that stays free between parked cars, or beside them (StVO, paragraph 12: 3.05 m with the margins of a
/// lorry).
inline constexpr double kFreeLane_m = 3;
/// The width that a row of parked cars takes of a carriageway.
inline constexpr double kRow_m = 2;

/// Returns the places along a road whose middles lie in a box, whatever lies there:
///
/// - in its parking lanes, across lanes of 4 m or more;
/// - at the kerbs of Road::kerb_parking, where kFreeLane_m stays free within the width limits;
/// - beside its outer edges, across and along it, for car parks (Place::surface is kParking).
///
/// Places are numbered from the start of the whole way, so the parts of a trimmed way have the places of the whole, bit
/// for bit. None lies in a bend of more than some 10 degrees. O(places + points).
std::vector<Place> places_along(const roads::Road& road, const Box2& box);

}  // namespace citykiln::cars

// Parking places along streets.
//
//     ______________ pavement ______________
//      [ car ] [ car ] [     ] [ car ]           in the bays of a parking lane: along, slanted or square to the road
//     - - - - - - - - - - - - - - - - - - - ►    axis
//      [ car ] [     ] [ car ] [ car ]           at the kerb: every 5.75 m along the way
//     ______________________________________
//      |c| |c| | | |c| |c|                       on a car park beside it: square, every 2.5 m, or along it
#pragma once

#include <span>
#include <vector>

#include "compiler/cars/place.h"
#include "compiler/geometry/box.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::cars {

/// The length of a place along a kerb, and the width of one on a car park that is square to the road. EAR 05: 5.7 m,
/// and 5.2 m at the ends of a row; 2.5 m.
inline constexpr double kKerbPlace_m = 5.75, kBeside_m = 2.5;
/// The width for driving that stays free beside cars at kerbs (StVO, paragraph 12: 3.05 m with the margins of a lorry).
inline constexpr double kFreeLane_m = 3;
/// The width that a row of cars at a kerb takes of a carriageway.
inline constexpr double kRow_m = 2;

/// Returns the places along a street whose middles lie in a box, before their ground is tested; none on other roads:
///
/// - in its parking lanes, within the bays of roads::bays_of(), painted or not. Crossings, and the last
///   roads::kLastBayEnds_m before a stop line, have none;
/// - at the kerbs of Road::kerb_parking, where lanes other than those for parking leave kFreeLane_m free;
/// - beside its outer edges, square to it and along it, for car parks (Place::surface is kParking).
///
/// Places are counted from the start of the OSM way, near a junction from its stop line, so parts of a trimmed way have
/// the same places, bit for bit. No place lies where the axis bends by more than 10 degrees, or where width limits
/// leave no room for a car. O(places + points).
/// @param stretches  The result of roads::stretches_of(road); may be empty if the road has no parking lanes.
std::vector<Place> places_along(const roads::Road& road, std::span<const roads::RoadStretch> stretches,
                                const Box2& box);

}  // namespace citykiln::cars

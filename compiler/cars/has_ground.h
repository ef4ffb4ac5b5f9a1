// Tests whether a parking place lies on ground for cars.
#pragma once

#include "compiler/cars/place.h"
#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::cars {

/// A street counts as built up where a building is this near to a place at its kerb.
inline constexpr double kBuiltUp_m = 22;

/// True if the ground below the middle and the long sides of a place is
///
/// - for places on a carriageway, that of the carriageway, outside of junctions, without rails from kerb to kerb; at
///   kerbs also with a building near, and no car park behind the kerb, whose cars could not leave;
/// - for places beside a street, kParking;
/// - for bays and drives, paved ground or the surfaces of yards;
/// - for mapped spaces, neither water nor a building nor a railway.
///
/// @param land_cover  With each road as one surface. O(edges near).
bool has_ground(const Place& place, const ground::LandCoverIndex& land_cover);

}  // namespace citykiln::cars

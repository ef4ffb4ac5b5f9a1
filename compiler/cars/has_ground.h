// Tests whether a parking place lies on ground for cars.
#pragma once

#include "compiler/cars/place.h"
#include "compiler/ground/cover/land_cover_index.h"

namespace citykiln::cars {

/// A street counts as built up where a building is this near to a place at its kerb.
inline constexpr double kBuiltUp_m = 22;

/// True if the ground of a place suits a car. It is tested at the middle and at 7 points of each long side, 0.25 m
/// inside of it, and is
///
/// - for places on a carriageway, that of the carriageway, outside of junctions, without rails from kerb to kerb; at
///   kerbs also with a building within kBuiltUp_m, and neither a car park, whose cars could not leave, nor another road
///   1 m behind the kerb;
/// - for places on car parks beside a road, kParking;
/// - for bays and drives, a car park or a surface of yards;
/// - on plots, unmapped land, or the land use whose element the plot belongs to, without yards;
/// - for mapped spaces, neither water nor a building nor a railway.
///
/// @param land_cover  With each road as one surface. O(edges near).
bool has_ground(const Place& place, const ground::LandCoverIndex& land_cover);

/// True if the corners of a car in a place, 0.3125 m inside of it, lie on such ground: a corner of a path may reach
/// between the points at which the ground of the place was tested.
bool is_on_ground(const OrientedRect& car, const Place& place, const ground::LandCoverIndex& land_cover);

}  // namespace citykiln::cars

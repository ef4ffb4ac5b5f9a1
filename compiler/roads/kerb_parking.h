// Decides at which kerbs of a street cars may park where the map has no parking lane.
#pragma once

#include <cstdint>

#include "compiler/map/features.h"

namespace citykiln::roads {

/// The widths of all lanes for driving together from which on cars park at one kerb, and at both: a row of 2 m beside 3
/// m or more.
inline constexpr double kOneRow_m = 5.5, kTwoRows_m = 7.5;
/// These widths where lines divide the lanes: rows beside two lanes of 2.75 m.
inline constexpr double kOneRowBesideLanes_m = 7.5, kTwoRowsBesideLanes_m = 9.5;

/// Returns the sides of a street on the ground at whose kerbs cars may park, as bits of map::RoadSide: of residential,
/// unclassified and tertiary streets, on sides of which tags say nothing about parking, where the outermost lane is one
/// for driving without arrows. One row is on the side of traffic, or on the other if tags exclude that; main roads of
/// one direction have one row at most. Living streets have none, since there cars park in marked places only (StVO,
/// sign 325). Buildings and junctions do not count here. O(lanes).
std::uint8_t kerb_parking_of(const map::Track& track);

}  // namespace citykiln::roads

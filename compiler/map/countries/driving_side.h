// The side of the road that traffic drives on at a place.
#pragma once

#include "compiler/map/cross_section.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::map {

/// Returns the side by the rings of driving_side.inc; right outside of all rings, also for invalid places. Longitudes
/// of 180 and more are taken minus 360. Land borders are accurate to 10 km, and to 1 km near the towns of its test; at
/// sea they lie anywhere between the coasts. O(rings).
///
/// Source: borders of Natural Earth 4.1, 1:10 million (public domain), simplified.
DrivingSide driving_side_at(LonLat place);

}  // namespace citykiln::map

// On which side of the road a place drives.
#pragma once

#include "compiler/map/lanes/lanes.h"
#include "compiler/map/plane.h"

namespace citykiln::map {

/// The side of the lands in driving_side.inc, else right. Borders on land are right to 10 km, near the towns of its
/// test to 1 km; at sea they lie anywhere between the coasts. Total: places that are none drive on the right. O(rings).
///
/// Source: borders of Natural Earth 4.1, 1:10 million (public domain), simplified.
DrivingSide driving_side_at(LonLat place);

}  // namespace citykiln::map

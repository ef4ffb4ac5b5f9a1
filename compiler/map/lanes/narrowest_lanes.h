// How narrow lanes can be whose width no tag states.
#pragma once

#include "compiler/map/cross_section.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::map {

/// Returns the least width of a lane on a road of a class, by lane_rules.inc, metres. Lanes used both ways, and whole
/// carriageways that are not divided into lanes, are at least a vehicle wide.
double narrowest_m(const Lane& lane, LandCoverClass surface);

}  // namespace citykiln::map

// The smallest widths of lanes whose width is not tagged.
#pragma once

#include "compiler/map/cross_section.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::map {

/// Returns the smallest width of a lane on a road of a class, by lane_rules.inc, metres. Lanes used both ways, and
/// carriageways that are not divided into lanes, are at least as wide as a vehicle (2.5 m).
double narrowest_m(const Lane& lane, LandCoverClass surface);

}  // namespace citykiln::map

// Assumes which footpaths and driveways are unpaved where no tag states their surface.
//
// Class of way and the land use at the middle of a way decide, in a row of surfaces.inc. Long ways are cut.
#pragma once

#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns the class that surface=gravel gives a way of a class in a land use, if a row says that it is unpaved there;
/// else the class.
map::LandCoverClass assumed_surface(map::LandCoverClass surface, LandUse land);

/// Returns the tracks with assumed surfaces, sorted by id: ways on the ground where Track::has_tagged_surface is false.
/// Longer ways are cut as by assume_pavements(); what decides lies within kPavementRadius_m. The order of features does
/// not matter. O(n log n).
std::vector<map::Track> assume_surfaces(const map::Features& features, Report& report);

}  // namespace citykiln::assume

// Assumes which footpaths and driveways are unpaved where no tag states their surface.
//
// A way is unpaved if surfaces.inc has a row for its class and for the land use that is most frequent on it.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns the tracks with assumed surfaces, sorted by id. A way may change if it lies on the ground and outside of
/// buildings, and Track::has_tagged_surface is false. Ways of more than kLongestWhole_m are cut as by
/// assume_pavements(). The radius is kPavementRadius_m (pavements.h). O(n log n), n: points of all features.
std::vector<map::Track> assume_surfaces(const map::FeatureView& features, Report& report);

}  // namespace citykiln::assume

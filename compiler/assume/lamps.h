// Assumes that streets and paved paths in built-up land are lit where no tag says whether they are.
//
// The rows of lamps.inc for class, land use, houses and country are added up for a stretch, the side with the
// higher score counts; it is lit where the sum is above 0. Lamps then stand as along streets that are tagged
// (props/street_lamps.h): none near mapped lamps. Open country, woods, farm tracks, driveways and motorways stay dark.
#pragma once

#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// True if a stretch of street or path without lit=* is lit.
bool is_assumed_lit(const map::Track& stretch, const BothSides& sides);

/// Returns the tracks with assumed lighting, sorted by id. Streets on the ground and on bridges change where
/// Track::has_tagged_lighting is false. Longer ways are cut as by assume_pavements(), and what decides lies within
/// kPavementRadius_m. The order of features does not matter. O(n log n).
std::vector<map::Track> assume_lamps(const map::Features& features, Report& report);

}  // namespace citykiln::assume

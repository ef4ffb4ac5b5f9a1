// Assumes strips of grass between the kerb and the pavement of streets in residential land.
//
//     houses    [###]   [###]   [###]
//     pavement  .....................     where a side has a pavement, and no tag says whether there is a verge;
//     verge     """""""""""""""""""""     where verges.inc has a width for class, land use and country;
//     ==============================>     and where the room beyond the kerb is wide enough for both
#pragma once

#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns the width of the verge that is assumed on a side of a stretch with a pavement; 0 for none.
/// @param pavement_m  The width of all that is raised on the side.
double assumed_verge_m(const map::Track& stretch, const SideFacts& side, double pavement_m);

/// Returns the tracks with assumed verges, sorted by id: lanes that verge=* and verge:left:width=* give. Streets on the
/// ground change on sides that are not in Track::tagged_verges. Longer ways are cut as by assume_pavements(), and what
/// decides lies within kPavementRadius_m. The order of features does not matter. O(n log n).
std::vector<map::Track> assume_verges(const map::Features& features, Report& report);

}  // namespace citykiln::assume

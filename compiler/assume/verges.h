// Assumes verges: strips of grass between the kerb and the pavement of streets in residential land.
//
//     houses    [###]   [###]   [###]
//     pavement  .....................     a side has a verge if it has a pavement, no tag states a verge or none,
//     verge     """""""""""""""""""""     verges.inc has a width for its class, country group and share of houses,
//     ==============================>     and the room beyond the kerb is wide enough for both
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// True if streets of its class and country group have verges where this share of a side has houses.
bool has_usual_verge(const map::Track& street, double houses);

/// Returns the tracks with assumed verges, sorted by id. A verge is the same lane as verge=* and verge:left:width=*
/// give; the pavement moves outwards by its width. A side of a street may change if the street lies on the ground, the
/// side is not in Track::tagged_verges, and all that is raised on it is a pavement, tagged or assumed.
///
/// Runs after assume_pavements(), and cuts ways of more than kLongestWhole_m as it does. The radius is
/// kPavementRadius_m (pavements.h), since only mapped streets limit the room. O(n log n), n: points of all features.
/// @param mapped  The tracks before pavements were assumed.
std::vector<map::Track> assume_verges(const map::FeatureView& features, std::span<const map::Track> mapped,
                                      Report& report);

}  // namespace citykiln::assume

// Assumes that streets and paved paths in built-up land are lit where no tag says whether they are.
//
// A stretch is lit if the sum of the rows of lamps.inc for its class, country group, land use and share of houses is
// above 0. The higher land use score and the higher share of houses of its two sides count. By these rows, roads in
// open country and woods, farm tracks, driveways and motorways are not lit. Lamps are then placed as along a street
// with lit=yes, and none near a mapped lamp (props/street_lamps.h).
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Returns all tracks of the map, sorted by id, with Track::is_lit set where lighting is assumed. Such tracks are
/// marked with Assumption::kLamps and counted in the report. These may change: streets and paved paths of 40 m or more,
/// on the ground and on bridges, whose Track::has_tagged_lighting is false. Ways on the ground that are longer than
/// kLongestWhole_m are cut into pieces, as assume_pavements() does it.
///
/// Depends on features within kPavementRadius_m (pavements.h) of a track. O(n log n) in the points of all features.
std::vector<map::Track> assume_lamps(const map::FeatureView& features, Report& report);

}  // namespace citykiln::assume

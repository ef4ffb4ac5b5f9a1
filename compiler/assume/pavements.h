// Assumes pavements beside streets in built-up land. It decides for each side of a street of which no tag says whether
// it has a pavement.
//
//     houses   [###]  [###]  [####]      1. a side has a pavement if the sum of the rows of pavements.inc for class,
//     pavement ...................          land use, houses and country group is above 0
//     ===========================>       2. it has none if a path runs beside its kerb (this path is the pavement), on
//     pavement ...................          the inner side of a roundabout, or towards the other carriageway
//     field                              3. it is as wide as usual, but not wider than the room that buildings, water,
//                                           rails, car parks and other streets leave
//
// An assumed pavement is the same lane as the tags sidewalk=* and sidewalk:width=* give (map/lanes).
#pragma once

#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// A way of at most this length is not cut: a side of it has an assumed pavement along the whole way or none. Nothing
/// is assumed of a longer segment without nodes.
inline constexpr double kLongestWhole_m = 512;
/// Longer ways are cut at one node in each window of this length (cut_way.h). A stretch has at most twice this length,
/// except between two nodes that are farther apart.
inline constexpr double kStretch_m = 256;
/// The result at a place of a way depends on what lies within this distance of it: the rest of the stretch, and what is
/// mapped beside it.
inline constexpr double kPavementRadius_m = kLongestWhole_m + kBeside_m;

/// The least width of an assumed pavement: two people can pass each other sideways, or one can push a pram.
inline constexpr double kNarrowestPavement_m = 1;

/// True if streets of this class have pavements in towns of this country group.
bool has_usual_pavements(map::LandCoverClass surface, map::CountryGroup country);

/// Returns the tracks with assumed pavements, sorted by id. A side of a street may change if it is not in
/// Track::tagged_pavements, and the street lies on the ground and outside of buildings. A way of more than
/// kLongestWhole_m becomes several tracks (cut_way(), Track::is_piece).
///
/// Neighbouring pieces of a way may have different pavements, as two ways may that a mapper has split. Bridges are
/// changed later (bridge_pavements.h), tunnels are not. O(n log n), n: points of all features.
std::vector<map::Track> assume_pavements(const map::FeatureView& features, Report& report);

}  // namespace citykiln::assume

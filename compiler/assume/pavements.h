// Assumes pavements beside streets in built-up land on which no tag says whether there is one.
//
//     houses   [###]  [###]  [####]      1. the rows of pavements.inc for class, land use, houses and country are added
//     pavement ...................          up for each side of a stretch; there is a pavement where the sum is above 0
//     ===========================>       2. none where a path runs beside the kerb (the pavement is mapped as a way of
//     pavement ...................          its own), inside a roundabout, or towards the other carriageway of a street
//     field                              3. as wide as usual there, but not wider than the room that buildings, water,
//                                           rails, car parks and other streets leave
//
// The lanes are those that the tags sidewalk=* and sidewalk:width=* give (map/lanes).
#pragma once

#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/contract/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Ways of this length or shorter have pavements all along or none. Longer ones are cut.
inline constexpr double kLongestWhole_m = 512;
/// Longer ways are cut into stretches of at most this length; a straight line without a node is not cut.
inline constexpr double kStretch_m = 256;
/// Everything that decides about a place of a way lies within this distance: the rest of a stretch, and what is mapped
/// beside it.
inline constexpr double kPavementRadius_m = kLongestWhole_m + kBeside_m;

/// The narrowest pavement that is assumed: two people who pass each other sideways, or one with a pram.
inline constexpr double kNarrowestPavement_m = 1;

/// Returns the width of the pavement that is assumed on a side of a stretch; 0 for none.
/// @param is_inside  True for the left side where traffic drives on the right, and the right side elsewhere: the inner
///                   one of roundabouts and dual carriageways.
double assumed_pavement_m(const map::Track& stretch, const SideFacts& side, bool is_inside);

/// Returns the tracks with assumed pavements, sorted by id. Streets change on sides that are not in
/// Track::tagged_pavements, on the ground, outside of buildings. A longer way becomes several tracks with the ids part
/// 0, 1, 2 … (Track::is_piece), which share the nodes at which it is cut.
///
/// Neighbouring pieces of a way may have different pavements, as ways that mappers cut. Bridges follow in
/// bridge_pavements.h; tunnels are not changed. The order of features does not matter. O(n log n).
std::vector<map::Track> assume_pavements(const map::Features& features, Report& report);

}  // namespace citykiln::assume

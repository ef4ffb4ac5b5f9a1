// Railways that are mapped inside of the carriageway of a street, as a way of their own.
//
//     ════════════════════════════════  kerb
//       - - - - - - ╪╪╪╪╪╪╪╪╪╪╪╪╪╪╪╪─╪╪╪╪╪╪   rails in the asphalt, and in ballast where they leave it
//     ═══════════════════════════╲
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// The least length along which a railway lies in a carriageway. Where it lies in one for less, it only crosses it.
inline constexpr double kLeastInStreet_m = 24;

/// Returns a railway as rails in a street: of class kStreetRails, with one lane on its axis, as wide as its carriageway
/// but at most 2.5 m, and without its level crossings. All else is unchanged.
Track as_street_rails(Track rails);

/// Returns the tracks, with railways cut into pieces where they run in streets. Pieces in streets are street rails
/// (as_street_rails()). They take the place of their way, in order along it; all other tracks are unchanged.
///
/// A railway runs in a street where its axis, sampled at most every 2 m, lies between the kerbs of a road, at an angle
/// of at most 26 degrees to it, for at least kLeastInStreet_m. Gaps of up to 16 m, such as junctions, are bridged. Both
/// are on the ground, and the road's class has the higher priority (land_cover_classes.inc). A cut moves to a vertex of
/// the way within 4 m, or to the way's end within 8 m.
///
/// ObjectId::part of a piece is the distance of its beginning from the way's, in steps of 4 m; a piece that begins with
/// the way has part 0. New vertices have node ids far below those of maps. Ways longer than 60 km, and tracks whose
/// part is not 0, stay whole. Cannot fail. O(n log n) in roads, plus O(length of railways · segments of the roads
/// near).
std::vector<Track> with_rails_in_streets(std::vector<Track> tracks);

}  // namespace citykiln::map

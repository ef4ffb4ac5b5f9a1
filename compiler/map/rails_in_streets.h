// Railways that are mapped inside of the carriageway of a street, as a way of their own.
//
//     ════════════════════════════════  kerb
//       - - - - - - ╪╪╪╪╪╪╪╪╪╪╪╪╪╪╪╪─╪╪╪╪╪╪   rails in the asphalt, and in ballast where they leave it
//     ═══════════════════════════╲
#pragma once

#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// The least length of rails that lie in a carriageway; where a track is inside of one for less, it crosses it.
inline constexpr double kLeastInStreet_m = 24;

/// Changes a railway to rails in a street (kStreetRails): one lane of at most 2.5 m on the axis, without level
/// crossings.
Track as_street_rails(Track rails);

/// Returns the tracks with street rails where a railway on the ground runs inside of a carriageway on the ground, whose
/// class has the higher priority (land_cover_classes.inc), in nearly its direction, for at least kLeastInStreet_m. The
/// ways are cut there: a way becomes up to three or more tracks, whose parts are their distance from the way's first
/// point in steps of 4 m. Ways with a length of over 60 km stay. O(length of railways) and O(n log n) in roads.
std::vector<Track> with_rails_in_streets(std::vector<Track> tracks);

}  // namespace citykiln::map

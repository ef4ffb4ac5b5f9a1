// The rows of track_rules.inc.
#pragma once

#include <string_view>

#include "compiler/map/land_cover_class.h"

namespace citykiln::map {

/// A row: tags of ways, and their class and lanes.
struct TrackRow {
  std::string_view key, value;
  LandCoverClass surface;
  double width_m;  ///< Width of one lane, or of the whole way if lanes are not counted.
  int lanes;       ///< The default number; 0: lanes are not counted.
};

inline constexpr TrackRow kTracks[] = {
#define TRACK(key, value, surface, width_m, lanes) {key, value, LandCoverClass::surface, width_m, lanes},
#include "compiler/map/lanes/track_rules.inc"
#undef TRACK
};

/// Returns the first row that the tags match, or null.
/// @param tag  Returns the value of a key, "" if it is not tagged.
template <typename Tag>
const TrackRow* track_row(Tag tag) {
  for (const TrackRow& row : kTracks)
    if (tag(row.key) == row.value) return &row;
  return nullptr;
}

}  // namespace citykiln::map

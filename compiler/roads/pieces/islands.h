// Islands: what streets enclose that is too small for anything but a kerb. Between a slip lane and its streets, where a
// road splits about a refuge, within a roundabout.
//
//     ___________      An island's ring runs along the axes of the streets about it: it lies under them, so that what
//     ____   ____      is seen of it is what they leave.
//      \ .\  |
//       \  \.|         .
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

struct TrafficIsland {
  ObjectId id;  ///< Of the lowest street about it.
  map::LandCoverClass surface{};
  Ring ring;  ///< Counter-clockwise, of vertices of axes.
};

/// No island reaches farther than this, across or along.
inline constexpr double kWidestIsland_m = 48;

/// The faces of the network of streets (residential ones and higher) that are islands: at most 300 m² from axis to
/// axis, within roundabouts any that kWidestIsland_m lets be. Those within larger roundabouts are planted. Each face
/// once, sorted by id. Where streets cross without meeting, faces are not what one sees: those are left out if their
/// ring crosses itself. Total. O(n log n).
std::vector<TrafficIsland> islands_of(std::span<const Road> roads);

}  // namespace citykiln::roads

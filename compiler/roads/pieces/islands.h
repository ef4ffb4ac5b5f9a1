// Traffic islands: small faces of the street network, between a slip lane and its streets, between the branches of a
// street that splits, or within a roundabout.
//
//     ___________      An island's ring runs along the axes of the streets around it and lies under them, so that the
//     ____   ____      part they do not cover is visible.
//      \ .\  |
//       \  \.|         .
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// A face of the street network that becomes an island, or a disk at a node.
struct TrafficIsland {
  ObjectId id;  ///< The lowest id of the streets around it.
  map::LandCoverClass surface{};
  Ring ring;  ///< Counter-clockwise: vertices of axes, or a 16-gon.
};

/// The radius of the painted circle of a mini roundabout.
inline constexpr double kPaintedCircle_m = 1.5;

/// The maximum extent of an island in x and y.
inline constexpr double kWidestIsland_m = 48;

/// Returns the faces between axes of streets (of class residential or higher) that are islands: faces of at most 300 m²
/// and, within a roundabout, faces of any area up to kWidestIsland_m wide. Faces over 80 m² within roundabouts are
/// planted. Turning loops have a raised island of kLoopIsland_m, mini roundabouts a painted circle. Sorted by id. A
/// face whose ring crosses itself, because streets cross without a common vertex, is no island. O(n log n).
std::vector<TrafficIsland> islands_of(std::span<const Road> roads);

}  // namespace citykiln::roads

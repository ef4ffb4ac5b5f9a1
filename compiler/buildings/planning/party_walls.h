// Finds party walls: parts of outlines where footprints are adjacent.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::buildings {

/// A part of an edge of a footprint's outer ring along which another footprint's ring runs in the opposite direction.
struct SharedWall {
  std::uint32_t edge = 0;       ///< Index into the outer ring.
  double from_m = 0, to_m = 0;  ///< Distances along the edge, from_m < to_m. Snapped; exact at shared corners.
  std::uint32_t neighbour = 0;  ///< Index of the other footprint.
  /// True: the distance between the walls is at most kCoplanar_m. False: at most kTouching_m.
  bool is_coplanar = false;
};

/// The largest distance between walls that touch, and between walls in one plane (1.5 steps of the map's 2^-7 m grid).
inline constexpr double kTouching_m = 0.06, kCoplanar_m = 0x1.8p-7;

/// Returns the shared walls of each footprint, sorted by edge, from_m and the neighbour's id. Ignores outlines that
/// have parts. Apart from indices the result does not depend on the order of the footprints. O(edges log edges) for
/// footprints that do not overlap.
std::vector<std::vector<SharedWall>> shared_walls(std::span<const map::Footprint> footprints);

}  // namespace citykiln::buildings

// Where buildings stand wall to wall.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::buildings {

/// A stretch of a footprint's outer ring along which another footprint's ring runs the other way.
struct SharedWall {
  std::uint32_t edge = 0;       ///< Of the outer ring.
  double from_m = 0, to_m = 0;  ///< Along it; from_m < to_m. Snapped, the ends exact where corners are shared.
  std::uint32_t neighbour = 0;  ///< A footprint's number.
  bool is_coplanar = false;     ///< Within kCoplanar_m; else within kTouching_m.
};

/// Nearer walls touch; between nearer ones nobody sees.
inline constexpr double kTouching_m = 0.06, kCoplanar_m = 0x1.8p-7;

/// Of each footprint, by its number: sorted by edge, from_m, neighbour. Outlines that parts replace count as absent.
/// The same whatever the order of footprints, but for the numbers. O(edges log edges) for footprints that lie apart.
std::vector<std::vector<SharedWall>> shared_walls(std::span<const map::Footprint> footprints);

}  // namespace citykiln::buildings

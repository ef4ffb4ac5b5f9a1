// Asks what covers the ground at a place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

inline constexpr std::uint32_t kNoSurface = 0xffffffffu;

/// Surfaces sorted into square buckets of a box. Refers to the surfaces it was made from, which must outlive it.
struct SurfaceMap {
  std::span<const Surface> surfaces;
  Box2 box;
  double bucket_m = 32;
  int columns = 0, rows = 0;
  std::vector<std::uint32_t> bucket_starts;  ///< columns * rows + 1 offsets into bucket_surfaces.
  std::vector<std::uint32_t> bucket_surfaces;
};

SurfaceMap map_surfaces(std::span<const Surface> surfaces, const Box2& box);

/// The index of the surface on top at p, or kNoSurface. p must lie in the map's box. O(vertices of the surfaces in p's bucket).
std::uint32_t surface_at(const SurfaceMap& map, Vec2 p);

/// The distance from p to the nearest border of a surface whose class has at least this priority; at most `reach_m`, 0 where such a surface
/// covers p. p must lie in the map's box; borders outside the box do not count.
double clearance_m(const SurfaceMap& map, Vec2 p, int priority, double reach_m);

}  // namespace citykiln::ground

// Traces the borders of regions, which are sets of faces.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/parcels/faces.h"

namespace citykiln::parcels {

/// A border ring of a region, and what lies beyond each edge.
struct TracedRing {
  std::vector<GridPoint> points;
  std::vector<Border> borders;
};

/// Returns the rings of each region, which touch themselves and each other at vertices only: counter-clockwise outside,
/// clockwise holes.
/// @param regions  The region of each face, or kNoIndex.
/// @param dropped  Points to leave out of all rings, sorted (straight_points.h).
/// Guarantees: the result does not depend on numbers of faces. O(n log n).
std::vector<std::vector<TracedRing>> trace_rings(const Faces& faces, const std::vector<std::uint32_t>& regions,
                                                 std::uint32_t region_count, const std::vector<GridPoint>& dropped);

/// Returns twice the signed area in grid steps. Exact. The ring has at least one point.
std::int64_t twice_area(const TracedRing& ring);

}  // namespace citykiln::parcels

// Faces too thin to be seen at a tolerance are given to a neighbour: kerbs, gaps between areas drawn twice, paths from
// afar. What simplify_borders() keeps by promise goes here on purpose.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/ground/border.h"

namespace citykiln::ground {

struct YieldedSlivers {
  std::vector<Border> borders;  ///< Sorted; a part of the old ones, of new owners.
  std::uint32_t faces = 0;      ///< That have yielded.
  double area_m2 = 0;           ///< Of these.
  double error_m = 0;  ///< No place that has another surface now was farther from a border of the face it was in.
};

/// Gives each thin face to the neighbour with whom it shares the longest border, the smallest face first.
///
/// @param borders      Meet only at their ends; the cell's own are among them, and both sides of each are right.
/// @param thickness_m  >= 0. A face is thin if every point of it lies within this of its border: strips up to twice as
/// wide go where they are found to be thin; up to this width they always are.
/// @param may_yield    Says of a surface that its faces may go.
/// Guarantees: error_m <= thickness_m; faces on the cell's border stay, so cells meet as before; a face that has taken
/// another stays; no vertex is new. A function of the set of borders. Total.
/// Method: a constrained Delaunay triangulation of the borders; a triangle is thin if its corners are close to a border
/// edge of its own, or its circle is small. Cost: O(n log n).
YieldedSlivers yield_slivers(std::span<const Border> borders, double thickness_m,
                             const std::function<bool(std::uint32_t)>& may_yield);

}  // namespace citykiln::ground

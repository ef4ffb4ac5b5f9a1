// Outlines of lots with fewer points on a coarser grid, which cost a manifest and the ground less.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::lots {

/// The largest distance of a dropped point of an outline from what remains, before points are rounded.
inline constexpr double kOutlineTolerance_m = 0.125;

/// Returns the polygons, as many and in their order, with fewer points: all are multiples of kOutlineStep_m (recipe.h).
///
/// Guarantees: shared borders stay identical, vertex for vertex. (They are shared if their points are bit-equal.) No
/// place of a border moves by more than kOutlineTolerance_m plus half a diagonal of the grid: 0.30 m, 5 cm more
/// than kUnderPavement_m (land_of.h). Junctions of three polygons are kept and rounded. Rings of which fewer than three
/// points remain are left out; without its outer ring a polygon is empty. Rings may touch and cross afterwards. A
/// polygon depends only on those with which it shares points. O(n log n) on average, at worst the square of the points
/// between two junctions.
/// Source: Douglas and Peucker, Cartographica 10 (1973), for each chain of points that the same polygons share.
std::vector<Polygon> coarse_outlines(std::span<const Polygon> polygons);

}  // namespace citykiln::lots

// Outlines of lots with fewer points on a coarser grid, which cost a manifest and the ground less.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::lots {

/// The largest distance of a dropped point of an outline from what remains, before points are rounded.
inline constexpr double kOutlineTolerance_m = 0.3125;

/// Returns the polygons, in their order, with fewer points: all are multiples of kOutlineStep_m (recipe.h).
///
/// Guarantees: borders that polygons have in common stay so, point by point. No place of a border moves by more than
/// kOutlineTolerance_m plus 0.71 · kOutlineStep_m: 0.49 m, less than kUnderPavement_m. Points where borders of three polygons meet stay, rounded.
/// Rings of which fewer than three points remain are left out; without its outer ring a polygon is empty. Rings may
/// touch and cross afterwards. A polygon depends only on those with which it shares points. O(n log n), for chains of
/// bounded length.
/// Source: Douglas and Peucker, Cartographica 10 (1973), for each chain of points that the same polygons share.
std::vector<Polygon> coarse_outlines(std::span<const Polygon> polygons);

}  // namespace citykiln::lots

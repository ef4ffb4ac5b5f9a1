// Polygon offsetting, inward or outward, with a depth for each edge, and the bands between old and new border.
//
//     +-----------+      bands: one for each edge, mitred between neighbours
//     |\_________/|      moved: the polygon that remains of an inset
//     | |       | |
//     | |_______| |
//     |/_________\|
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// The result of moving the border of a polygon.
struct OffsetPolygon {
  std::vector<Polygon> moved;               ///< The polygon with moved border; none, one or several.
  std::vector<std::vector<Polygon>> bands;  ///< Between old and new border: one per edge of outer, then of each hole.
  bool on_grid = false;                     ///< True if overlay() was used, which snaps the old border to its grid.
};

/// The largest ratio of a mitred corner's distance to the depth; sharper corners are bevelled.
inline constexpr double kMitreLimit = 4;

/// Moves the border inward.
/// @param depth_m  One depth >= 0 per edge of outer, then of each hole. An edge of depth 0 does not move.
///
/// Guarantees: moved and bands share no area and cover the polygon, and lie within it, up to two steps of the grid at
/// each border. The grid has steps of 2^-16 m if all coordinates are below 1000 m, else of 2^-10 m: pass polygons
/// relative to a near point. Cannot fail: where moved edges pass each other, pieces split, vanish or overlap, and the
/// band of the edge with the lower index wins; a ring that is not simple counts by its winding number. Cost: O(n²) if
/// edges do not pass each other, else overlay()'s.
/// Method: intersects the moved lines of neighbouring edges. If the resulting rings are simple and their areas add up,
/// they are the result, off the grid. Else the strips of all edges are overlaid on the polygon on the grid (overlay.h).
OffsetPolygon inset(const Polygon& polygon, std::span<const double> depth_m);

/// Moves the border outward. The bands lie outside of the polygon, and `moved` is the polygon with its bands.
OffsetPolygon outset(const Polygon& polygon, std::span<const double> depth_m);

}  // namespace citykiln

// A polygon's border moved inward or outward, each edge by its own depth, and the bands in between.
//
//     +-----------+      bands: one an edge, mitred where neighbours meet;
//     |\_________/|      inner: what is left of an inset.
//     | |       | |
//     | |_______| |
//     |/_________\|
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

struct OffsetPolygon {
  std::vector<Polygon> moved;               ///< The polygon with its border moved: smaller, larger, none, or several.
  std::vector<std::vector<Polygon>> bands;  ///< Between old and new border: per edge of outer, then of each hole.
  bool on_grid = false;                     ///< Made by the overlay, so that the old border has moved by its grid.
};

/// No corner that a border goes around reaches farther than this times the depth; sharper ones are bevelled.
inline constexpr double kMitreLimit = 4;

/// @param depth_m  Per edge, outer's first, then each hole's: >= 0. An edge of depth 0 stays.
///
/// Guarantees: moved and bands share no area and cover the polygon, within 2^-14 m of each border; they lie within it.
/// Total: where moved edges pass each other, pieces split, vanish or overlap, and the lower edge's band wins; a ring
/// that is not simple is taken by its winding. Cost: O(n²) where edges do not pass each other, else the overlay's.
/// Method: neighbouring edges' moved lines are met; if the rings so made are simple and all areas add up, that is it;
/// else strips of all edges are overlaid on the polygon (overlay.h), on a grid of 2^-16 m, coarser for polygons over
/// 1 km.
OffsetPolygon inset(const Polygon& polygon, std::span<const double> depth_m);

/// The same outward: `moved` is the polygon and its bands together; bands lie outside of the polygon.
OffsetPolygon outset(const Polygon& polygon, std::span<const double> depth_m);

}  // namespace citykiln

// Rectangles at any angle in the plane.
//
//     ahead      ┌──────────────┐    at is the middle; length_m lies along `ahead`, width_m across it.
//       ──►      │      at      │
//                └──────────────┘
#pragma once

#include <array>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/vec.h"

namespace citykiln {

/// A rectangle.
struct OrientedRect {
  Vec2 at{}, ahead{};  ///< Plane metres; ahead has length 1.
  double length_m = 0, width_m = 0;
};

/// Returns the corners, counter-clockwise from the rear right one.
std::array<Vec2, 4> corners_of(const OrientedRect& rect);

/// Returns the box around a rectangle.
Box2 box_of(const OrientedRect& rect);

/// True if the projections of two rectangles on each of their four side directions share more than border_m. If
/// border_m is negative, -border_m is a clearance: true if no side separates the rectangles by it. Corners may be
/// farther apart.
bool overlap(const OrientedRect& a, const OrientedRect& b, double border_m);

/// Rectangles with a spatial index.
struct RectIndex {
  std::vector<OrientedRect> all;
  BoxGrid grid;
};

/// Returns the index of rectangles. O(n).
RectIndex index_rects(std::vector<OrientedRect> all);

/// True if overlap() holds for any indexed rectangle. Requires border_m >= 0. O(rectangles near).
bool overlaps_any(const RectIndex& rects, const OrientedRect& rect, double border_m);

}  // namespace citykiln

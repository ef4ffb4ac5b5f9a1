// Rings that reach across half a continent, cut where nobody looks any more.
#pragma once

#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {

/// The part of a ring inside a box, as one ring: where the ring leaves the box, the box's sides lead to where it comes
/// back (perhaps to and fro, along a side of no width).
///
/// @param box  Corners on the plane's grid.
/// Guarantees: every point well inside the box keeps its winding number; nothing lies outside; points are on the
/// plane's grid, so an edge that is cut moves by less than 2^-10 m. A ring inside the box stays as it is. Empty where
/// less than a triangle is left. O(n). Source: Sutherland, Hodgman, "Reentrant polygon clipping", 1974.
Ring clip_ring(std::span<const Vec2> ring, const Box2& box);

}  // namespace citykiln::map

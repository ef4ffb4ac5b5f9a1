// Clips rings to a box, for areas such as seas that continue far outside the compiled extent.
#pragma once

#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {

/// Returns the part of a ring inside a box as one ring. Where the ring leaves the box, the result follows the sides of
/// the box to the place where the ring returns. It may run to and fro along a side without enclosing area. Empty if
/// less than a triangle is left.
///
/// @param ring  Plane metres, without a repeated last point.
/// @param box   Corners are multiples of kMapStep_m (1/128 m).
///
/// Guarantees: a ring inside the box is returned unchanged; no point of the result lies outside the box; new points are
/// multiples of kMapStep_m, so winding numbers of points in the box change only within kMapStep_m of the box's sides
/// and of cut edges. O(n). Source: Sutherland, Hodgman, "Reentrant polygon clipping", 1974.
Ring clip_ring(std::span<const Vec2> ring, const Box2& box);

}  // namespace citykiln::map

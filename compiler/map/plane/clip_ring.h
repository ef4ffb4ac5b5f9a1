// Clips rings that extend far beyond the extent.
#pragma once

#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {

/// Returns the part of a ring inside a box as one ring. Where the ring leaves the box, the result follows the box's
/// sides to the place where the ring returns; it may run to and fro along a side without enclosing area.
///
/// @param box  Corners on the plane's grid.
///
/// Guarantees: points in the box keep their winding numbers, except within kMapStep_m of its sides and of cut edges, as
/// new points are snapped to the plane's grid; no point lies outside the box; a ring inside the box is returned
/// unchanged. Empty if less than a triangle is left. O(n). Source: Sutherland, Hodgman, "Reentrant polygon clipping",
/// 1974.
Ring clip_ring(std::span<const Vec2> ring, const Box2& box);

}  // namespace citykiln::map

// Clips rings that extend far beyond the region.
#pragma once

#include <span>

#include "compiler/geometry/polygon.h"

namespace citykiln::map {

/// Returns the part of a ring inside a box as one ring. Where the ring leaves the box, the result follows the sides to
/// where it returns, perhaps to and fro along a side without area.
///
/// @param box  Corners on the plane's grid.
///
/// Guarantees: every point well inside the box keeps its winding number; nothing lies outside; points are on the
/// plane's grid, so a cut edge moves by less than kMapStep_m; a ring inside the box stays unchanged. Empty where less
/// than a triangle is left. O(n). Source: Sutherland, Hodgman, "Reentrant polygon clipping", 1974.
Ring clip_ring(std::span<const Vec2> ring, const Box2& box);

}  // namespace citykiln::map

// Do rings cross or touch? Exact for points of the plane's grid.
#pragma once

#include <span>

#include "compiler/geometry/vec.h"

namespace citykiln {

/// No two edges cross, touch or overlap, but neighbours at their common end; no edge is a point. Exact for points on
/// the plane's grid that lie within 16 km of each other. O(n²): for rings of a few dozen points.
bool is_simple(std::span<const Vec2> ring);

/// Some edge of one crosses or touches some edge of the other. Exact as is_simple. O(n m).
bool borders_touch(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace citykiln

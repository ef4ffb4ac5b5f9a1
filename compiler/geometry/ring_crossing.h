// Tests of rings for crossing and touching, exact for points on the plane's grid.
#pragma once

#include <span>

#include "compiler/geometry/vec.h"

namespace citykiln {

/// True if no two edges cross, touch or overlap, except neighbours at their common end, and no edge has length 0. Exact
/// for points on the plane's grid within 16 km of each other. O(n²): meant for rings of a few dozen points.
bool is_simple(std::span<const Vec2> ring);

/// True if any edge of a crosses or touches any edge of b. Exact like is_simple(). O(n m).
bool borders_touch(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace citykiln

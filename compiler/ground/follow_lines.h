// Straight lines that lie on the carved ground are cut where it bends under them, so that what is triangulated between
// them follows it.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/ground/carving.h"

namespace citykiln::ground {

/// What lines and faces may stray from the carved ground where they are looked at.
inline constexpr double kFollow_m = 0.0625;

/// The line from a to b, both left out, cut in halves until no piece is shorter than two metres or strays from the
/// ground by more than kFollow_m in its quarters, on any layer. The bends of the terrain itself do not count: they have
/// lines of their own. The points are snapped to the 2^-10 m grid and depend on the line alone, whichever way it runs;
/// none where nothing is carved. O(points).
std::vector<Vec2> bends_along(const Carving& carving, Vec2 a, Vec2 b);

/// Surfaces with points in those edges of their rings that come near the cell. Roads' are left as they are: they follow
/// their profiles. O(edges).
std::vector<Surface> bent_rings(std::span<const Surface> surfaces, const Carving& carving, const Box2& cell);

/// Points on a cell's border: between them the carved ground strays from the terrain by what is linear. They depend on
/// the side alone, so both cells have them; none where nothing is carved. O(1).
std::vector<GridPoint> bends_on_border(const Carving& carving, const Box2& cell);

}  // namespace citykiln::ground

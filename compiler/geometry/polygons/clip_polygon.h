// Makes valid polygons from rings that may cross: their union, and its part in a box.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Returns the area where the winding numbers of the rings add up to more than zero, as valid polygons.
///
/// Guarantees: rings are simple and touch each other at vertices only; no vertex is farther than 2^-10 m from rings on
/// the plane's grid, or 2^-9 m from others. Accepts any rings. Cost: O(edges²).
std::vector<Polygon> united(std::span<const Ring> rings);

/// Returns the part of united(rings) in a box. Edges on the box's border have a vertex at each whole multiple of 128 m,
/// so that they stay nearly straight in other projections.
/// @param box  Corners on the plane's grid. Boxes side by side give polygons that share the edges between them.
std::vector<Polygon> united_in(std::span<const Ring> rings, const Box2& box);

/// Returns copies of the outer ring and of the holes, in this order.
std::vector<Ring> copied_rings(const Polygon& polygon);

}  // namespace citykiln

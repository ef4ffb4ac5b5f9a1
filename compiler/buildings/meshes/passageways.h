// The openings that ways cut into a building, seen from above (Passageway in recipe.h).
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/line_part.h"

namespace citykiln::buildings {

/// Returns the area of an opening as overlapping convex rings, counter-clockwise, snapped. O(n) in points of its axis.
std::vector<Ring> opening_rings(const Passageway& passageway);

/// Returns the parts of the line from a to b inside the openings of a building, sorted, without overlaps; none if a
/// equals b. Parts shorter than `least_m` are left out; an end nearer than `least_m` to a or b is moved there. O(n log
/// n) in rings of the openings.
std::vector<LinePart> parts_in_openings(const Building& building, Vec2 a, Vec2 b, double least_m);

/// True if a place is inside an opening of a building, or within 2^-9 m of its side. Walls there do not reach the
/// ground. O(n) in points of the openings.
bool is_in_opening(const Building& building, Vec2 p);

}  // namespace citykiln::buildings

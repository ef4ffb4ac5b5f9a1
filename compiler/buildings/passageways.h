// The openings that ways cut into a building, in plan.
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Returns the plan of an opening as overlapping convex rings, counter-clockwise, snapped. O(n).
std::vector<Ring> rings_of(const Passageway& passageway);

/// A distance from one end of a line to another, metres.
struct LineStretch {
  double from_m = 0, to_m = 0;
};

/// Returns the parts of the line from a to b inside the openings of a building, sorted, without overlaps. Ends nearer
/// than `least_m` to a or b are moved there. O(openings).
std::vector<LineStretch> stretches_in_openings(const Building& building, Vec2 a, Vec2 b, double least_m);

/// True if a place is in an opening of a building, or on its side: no wall reaches the ground there. O(openings).
bool is_in_opening(const Building& building, Vec2 p);

}  // namespace citykiln::buildings

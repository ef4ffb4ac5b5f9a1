// How far a linear piece is off the heightfield, vertically, and where most. Both are piecewise linear, so the largest
// distance lies at a vertex of their overlay: a vertex of either, or a crossing of an edge with a line of the field.
#pragma once

#include <array>

#include "compiler/geometry/vec.h"
#include "compiler/map/heightfield.h"

namespace citykiln::ground {

struct WorstPoint {
  double error_m = 0;
  Vec2 at;
};

/// Along an edge from a to b, ends left out. O(field lines crossed).
WorstPoint worst_on_edge(const map::Heightfield& field, Vec3 a, Vec3 b);

/// The same along an edge that is parallel to an axis, in a line of whole metres, ends on the 2^-10 m grid, but that
/// diagonals are looked at where a triangulation with the field's lines as edges has them: at the point of the grid
/// nearest to where they cross. To the bit what that finds (reference.h). The same from b to a.
WorstPoint worst_on_straight_edge(const map::Heightfield& field, Vec3 a, Vec3 b);

/// At the field's vertices inside a triangle (in plan, counter-clockwise), its edges left out. O(field vertices in its
/// box).
WorstPoint worst_inside(const map::Heightfield& field, const std::array<Vec3, 3>& corners);

}  // namespace citykiln::ground

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

/// At the field's vertices inside a triangle (in plan, counter-clockwise), its edges left out. O(field vertices in its
/// box).
WorstPoint worst_inside(const map::Heightfield& field, const std::array<Vec3, 3>& corners);

}  // namespace citykiln::ground

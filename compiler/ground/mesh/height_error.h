// Finds the largest vertical error of an edge or face of a mesh against the terrain. Both are piecewise linear, so the
// largest error is at a vertex of their overlay: a vertex of either, or a crossing of an edge with a grid line.
#pragma once

#include <array>

#include "compiler/geometry/vec.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The largest error and its place; error_m 0 if there is none.
struct WorstPoint {
  double error_m = 0;
  Vec2 at;
};

/// Replaces the worst point by `at` if the error there is larger.
inline void consider(WorstPoint& worst, double error_m, Vec2 at) {
  if (error_m > worst.error_m) worst = {error_m, at};
}

/// Returns the largest error along an edge from a to b (plane metres), without its ends. O(grid lines crossed).
WorstPoint worst_on_edge(const map::Heightfield& field, Vec3 a, Vec3 b);

/// Returns the largest error along an edge of the cell's border (parallel to an axis, on whole metres, ends on the
/// 2^-10 m grid), without its ends. At diagonals of the terrain it is evaluated at the grid point nearest to the
/// crossing, where a triangulation with grid lines as edges has a vertex; so a graded neighbouring cell gets equal
/// bits. Both directions of an edge give the same result.
WorstPoint worst_on_straight_edge(const map::Heightfield& field, Vec3 a, Vec3 b);

/// Returns the largest error at grid vertices inside a triangle (in plan, counter-clockwise), without its edges.
/// O(vertices in its box).
WorstPoint worst_inside(const map::Heightfield& field, const std::array<Vec3, 3>& corners);

}  // namespace citykiln::ground

// Finds the largest vertical error of an edge or face of a mesh against the terrain. The terrain is a grid of heights
// whose squares are split by diagonals into triangles. Mesh and terrain are both piecewise linear, so the largest error
// is at a vertex of the mesh, at a vertex of the terrain, or where an edge of the mesh crosses a grid line or diagonal.
#pragma once

#include <array>

#include "compiler/geometry/vec.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::ground {

/// The largest error and its place.
struct WorstPoint {
  double error_m = 0;  ///< 0 if there is no error.
  Vec2 at;             ///< The place, in metres on the map plane.
};

/// Replaces the worst point by `at` if the error there is larger.
inline void consider(WorstPoint& worst, double error_m, Vec2 at) {
  if (error_m > worst.error_m) worst = {error_m, at};
}

/// Returns the largest error along an edge from a to b, without its ends. O(grid lines crossed).
/// @param terrain  The terrain.
/// @param a, b   The ends of the edge, in metres on the map plane with their heights.
WorstPoint worst_on_edge(const map::Heightfield& terrain, Vec3 a, Vec3 b);

/// Returns the largest error along an edge on the border of a ground cell, without its ends. Ground cells are squares
/// of the map plane whose ground is meshed separately. The result must be equal in the cells on both sides, to the last
/// bit.
///
/// Where the edge crosses a diagonal of the terrain, the error is evaluated at the multiple of 2^-10 m nearest to the
/// crossing. The other cell may have roads that change its ground: its mesh is then compared with a triangulation that
/// has the terrain's edges, and the vertex of that triangulation at the crossing is rounded to the same place. Both
/// directions of an edge give the same result. O(grid lines crossed).
/// @param a, b  The ends of the edge, which is parallel to the x or y axis. Its distance from that axis is in whole
///              metres; the ends are at multiples of 2^-10 m along it.
WorstPoint worst_on_cell_border(const map::Heightfield& terrain, Vec3 a, Vec3 b);

/// Returns the largest error at grid vertices in a triangle (in plan, counter-clockwise): inside it and on its edges,
/// except on the sides of its box. O(vertices in its box).
WorstPoint worst_inside(const map::Heightfield& terrain, const std::array<Vec3, 3>& corners);

}  // namespace citykiln::ground

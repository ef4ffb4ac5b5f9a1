// The raw heights of the plane: a piecewise-linear surface on a grid aligned to the plane.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln::map {

/// Heights are whole multiples of this.
inline constexpr double kHeightQuantum_m = 0x1p-6;

/// Steps and places of vertices are whole multiples of this, so that every vertex, and whatever lies a whole share of
/// up to a 128th of the way from one to another, lies on the grid of the plane.
inline constexpr double kStepUnit_m = 0x1p-3;

/// Vertex (i, j) lies at (min.x + i step_m.x, min.y + j step_m.y); each rectangle is split by its diagonal from
/// south-west to north-east.
struct Heightfield {
  Vec2 min;
  Vec2 step_m{64, 64};                ///< East and north; whole multiples of kStepUnit_m.
  int columns = 0, rows = 0;          ///< Vertices, at least 2 each.
  std::vector<std::int32_t> heights;  ///< In units of kHeightQuantum_m, row by row, row 0 the southernmost.
  double resampling_error_m =
      0;  ///< Largest vertical distance from a source sample to the surface, where sources are not void.
  bool operator==(const Heightfield&) const = default;

  double height_m_at_vertex(int i, int j) const {
    return heights[static_cast<std::size_t>(j) * columns + i] * kHeightQuantum_m;
  }
  /// Exact.
  Vec2 vertex(int i, int j) const { return {min.x + i * step_m.x, min.y + j * step_m.y}; }
  Box2 box() const { return {min, vertex(columns - 1, rows - 1)}; }
  double longer_step_m() const { return std::max(step_m.x, step_m.y); }
  double shorter_step_m() const { return std::min(step_m.x, step_m.y); }
};

/// The rectangle that holds a point, and where in it.
struct CellPosition {
  int i, j;     ///< Of its south-western vertex.
  double u, v;  ///< East and north, 0 to 1.
};
/// Points outside are moved to the rim. Which rectangle is exact, and u and v are what is left beyond its vertex, which
/// is subtracted before anything is divided: so they are functions of the place and the lattice alone, wherever the
/// field begins. O(1).
CellPosition cell_at(const Heightfield& field, Vec2 p);

/// Piecewise-linear height, exact but for the rounding of the last operations, and at vertices exact; outside the box,
/// that of the nearest point in it. A function of the place and the heights about it alone, to the bit. O(1).
double height_m_at(const Heightfield& field, Vec2 p);
/// The corner of its rectangle that a point is nearest to, in steps.
Vec2 nearest_vertex(const Heightfield& field, Vec2 p);
/// The surface's normal at a point, smoothed: the normals of the vertices' centred differences, interpolated; a
/// function of the place alone.
Vec3 normal_at(const Heightfield& field, Vec2 p);
/// The part of the field that covers the box with one vertex beyond on every side (clamped to the field). Heights and
/// vertices stay where they are, so heights and normals in the box are the same to the bit.
Heightfield window_of(const Heightfield& field, const Box2& box);

}  // namespace citykiln::map

// The raw heights of the plane: a piecewise-linear surface on a grid aligned to the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln::map {

/// Heights are whole multiples of this.
inline constexpr double kHeightQuantum_m = 0x1p-6;

/// Vertex (i, j) lies at (min.x + i step, min.y + j step); each square is split by its diagonal from south-west to
/// north-east. `min` and `step_m` are whole metres and step_m is a power of two, so every vertex lies on the plane's
/// grid.
struct Heightfield {
  Vec2 min;
  double step_m = 64;
  int columns = 0, rows = 0;          ///< Vertices, at least 2 each.
  std::vector<std::int32_t> heights;  ///< In units of kHeightQuantum_m, row by row, row 0 the southernmost.
  double resampling_error_m =
      0;  ///< Largest vertical distance from a source sample to the surface, where sources are not void.
  bool operator==(const Heightfield&) const = default;

  double height_m_at_vertex(int i, int j) const {
    return heights[static_cast<std::size_t>(j) * columns + i] * kHeightQuantum_m;
  }
  Box2 box() const { return {min, {min.x + (columns - 1) * step_m, min.y + (rows - 1) * step_m}}; }
};

/// Exact piecewise-linear height; outside the box, that of the nearest point in it. O(1).
double height_m_at(const Heightfield& field, Vec2 p);
/// The vertex nearest to a point, in plan; may lie outside the field where the point does.
Vec2 nearest_vertex(const Heightfield& field, Vec2 p);
/// The surface's normal at a point, smoothed: the normals of the vertices' centred differences, interpolated; a
/// function of the place alone.
Vec3 normal_at(const Heightfield& field, Vec2 p);
/// The part of the field that covers the box with one vertex beyond on every side (clamped to the field). Heights and
/// vertices stay where they are, so heights and normals at points of the plane's grid in the box are the same to the
/// bit.
Heightfield window_of(const Heightfield& field, const Box2& box);

}  // namespace citykiln::map

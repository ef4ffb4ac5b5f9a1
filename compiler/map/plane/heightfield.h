// Heightfields: piecewise linear surfaces over a grid whose sides are parallel to the plane's axes. Between coarse
// samples their vertices lie on a smooth surface (smooth_land.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/geometry/vec.h"

namespace citykiln::map {

/// The step of stored heights.
inline constexpr double kHeightQuantum_m = 0x1p-6;

/// Steps and positions of samples are multiples of this, so that every sample, and every point a whole 128th of the way
/// from one to another, lies on the grid of the plane.
inline constexpr double kStepUnit_m = 0x1p-3;

/// A grid of heights. Vertex (i, j) lies at (min.x + i step_m.x, min.y + j step_m.y), plane metres. Each cell of the
/// grid is split by its diagonal from south-west to north-east.
struct Heightfield {
  Vec2 min;
  Vec2 step_m{64, 64};                ///< East and north; whole multiples of kStepUnit_m / parts.
  int columns = 0, rows = 0;          ///< Vertices, at least 2 each.
  std::vector<std::int32_t> heights;  ///< In units of kHeightQuantum_m, row by row, row 0 the southernmost.
  /// Largest vertical distance from a source sample that is not void to the surface, rounded up to kHeightQuantum_m.
  /// Only rasters in degrees are measured; 0 if there is none.
  double resampling_error_m = 0;
  int parts = 1;  ///< Steps from sample to sample. If there are several, vertex (0, 0) is a sample.
  /// The heights from which smooth_land() made the others, as far as one sample beyond them, row by row. Empty if each
  /// vertex is a sample.
  std::vector<std::int32_t> samples{};
  bool operator==(const Heightfield&) const = default;

  double height_m_at_vertex(int i, int j) const {
    return heights[static_cast<std::size_t>(j) * columns + i] * kHeightQuantum_m;
  }
  /// The exact position of a vertex.
  Vec2 vertex(int i, int j) const { return {min.x + i * step_m.x, min.y + j * step_m.y}; }
  Box2 box() const { return {min, vertex(columns - 1, rows - 1)}; }
  /// The distance of samples, east and north.
  Vec2 sample_step_m() const { return step_m * parts; }
  double longer_sample_step_m() const { return std::max(step_m.x, step_m.y) * parts; }
  double shorter_sample_step_m() const { return std::min(step_m.x, step_m.y) * parts; }
  int sample_columns() const { return parts == 1 ? columns : (columns - 1) / parts + 3; }
  int sample_rows() const { return parts == 1 ? rows : (rows - 1) / parts + 3; }
};

/// The cell that contains a point, and the point's position in the cell.
struct CellPosition {
  int i, j;     ///< Indices of the cell's south-western vertex.
  double u, v;  ///< Position east and north of that vertex, as shares of the cell, 0 to 1.
};
/// Returns the cell of a point; points outside are moved to the border. The cell is exact. u and v are computed from
/// the offset to its vertex, so they depend on the place and the lattice only, not on the field's extent. O(1).
CellPosition cell_at(const Heightfield& field, Vec2 p);

/// Returns the height at a point; outside the field, the height at the nearest point in it. Exact at vertices,
/// elsewhere up to the rounding of the last operations. Every bit depends on the place and the cell's heights only.
/// O(1).
double height_m_at(const Heightfield& field, Vec2 p);
/// Returns the corner of a point's cell that is nearest to it, measured in steps.
Vec2 nearest_vertex(const Heightfield& field, Vec2 p);
/// Returns the smoothed normal at a point: the normals of the vertices by central differences, interpolated bilinearly.
Vec3 normal_at(const Heightfield& field, Vec2 p);
/// Returns the part of the field that covers a box and one more vertex on every side, from sample to sample, clamped to
/// the field. Heights and normals in the box do not change by a bit.
Heightfield window_of(const Heightfield& field, const Box2& box);

}  // namespace citykiln::map

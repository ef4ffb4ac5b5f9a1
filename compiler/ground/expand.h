// The ground: one conforming constrained triangulation per cell, every face of one surface, with a certified vertical
// error.
//
//   1. the borders of all surfaces and the cell's own border become one arrangement on the 2^-10 m grid
//   (geometry/arrange)
//   2. its faces learn what covers them by counting the rings they are inside of; borders between equal faces are
//   forgotten
//   3. what is left is split where the height along it would be off by more than the tolerance
//   4. a constrained Delaunay triangulation takes samples of the field until no point is off by more than the tolerance
//   (Garland, Heckbert 1995)
//
// See ground.md for why neighbouring cells fit byte for byte, and for the error's proof.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/mesh.h"
#include "compiler/ground/recipe.h"
#include "compiler/ground/surface_map.h"
#include "compiler/map/heightfield.h"

namespace citykiln::ground {

struct GroundMesh {
  Mesh mesh;                                ///< Upwards; positions on the 2^-10 m grid; normals of the field.
  std::vector<std::uint32_t> face_surface;  ///< One a triangle: index into the surfaces given, or kNoSurface.
  double error_m =
      0;  ///< Largest vertical distance between mesh and field: measured at all vertices of their overlay, so exact.
};

/// The ground of one cell.
///
/// @param surfaces     All that touch the cell, trimmed or not (map of roads, areas, footprints); others are ignored.
/// @param cell         Corners on whole metres.
/// @param tolerance_m  > 0.
/// Guarantees: triangles counter-clockwise from above, they tile the cell exactly (sum of plan areas equals the
/// cell's); each inner edge has two faces; border vertices depend only on surfaces and heights that touch the border,
/// so cells made apart meet vertex for vertex; vertices take the field's height rounded to 2^-10 m; error_m <=
/// max(tolerance_m, what a further vertex could not mend; then diagnosed kToleranceNotMet). Cost: n log n in border
/// segments and inserted samples.
GroundMesh expand_cell(std::span<const Surface> surfaces, const map::Heightfield& heights, const Box2& cell,
                       double tolerance_m, Report& report);

}  // namespace citykiln::ground

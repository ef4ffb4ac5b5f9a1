// The ground: one conforming constrained triangulation per cell, every face of one surface, with a certified vertical
// error against the graded terrain.
//
//   1. the borders of all surfaces, the lines along which the graded terrain bends and the cell's own border become one
//      arrangement on the 2^-10 m grid; triangulated, with the carved heights at its vertices, it is the reference
//   2. its faces learn what covers them by counting the rings they are inside of; borders between equal faces are
//      forgotten
//   3. thin faces yield to their neighbours and borders are simplified, both to a share of the tolerance
//   4. what is left is split where the height along it would be off by more than the tolerance
//   5. a constrained Delaunay triangulation takes points of the reference until no face is off by more than the
//      tolerance
//   6. where surfaces of different layers meet at different heights, vertical faces close the step
//
// See ground.md for why neighbouring cells fit byte for byte, and for the error's proof.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/box.h"
#include "compiler/geometry/mesh.h"
#include "compiler/ground/cover/border.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/cover/merge_slivers.h"
#include "compiler/ground/grading/graded_normals.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/ground/mesh/reference.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

struct GroundMesh {
  Mesh mesh;  ///< Upwards, then vertical faces; positions on the 2^-10 m grid; normals of the graded terrain.
  std::vector<std::uint32_t> face_cover;  ///< One a triangle: index into the surfaces given, or kNoLandCover.
  std::uint32_t first_vertical = 0;       ///< Triangles from here on stand vertical: kerbs, quays, walls.
  double border_error_m = 0;  ///< Largest distance in plan between borders and what they stand for, both ways.
  double error_m = 0;  ///< Largest vertical distance between mesh and graded terrain, layer by layer: measured at all
                       ///< vertices of their overlay, so exact.
};

/// What a cell is made of before any tolerance.
struct PreparedCell {
  std::vector<FaceHeight> heights;           ///< One a surface.
  Regions between_borders;                   ///< Between the borders that are seen.
  std::vector<CellBorderPiece> cell_border;  ///< Where they run along the cell's own.
  Reference reference;                       ///< What heights are measured against.
};

/// The dearer half of generate_cell: levels that share surfaces and carving share this too. Parameters as there; what
/// is returned refers to the graded terrain.
PreparedCell prepare_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell);

/// The ground of one cell.
///
/// @param surfaces     All that touch the cell, trimmed or not (map of roads, areas, footprints); others are ignored.
/// @param carving      Of all that is within its reach of the cell.
/// @param cell         Corners on whole metres.
/// @param tolerance_m  > 0.
/// Guarantees: triangles that are not vertical are counter-clockwise from above, they tile the cell exactly (sum of
/// plan areas equals the cell's); each inner edge has two faces, or an vertical one between them; border vertices
/// depend only on surfaces and heights that touch the border, so cells made apart meet vertex for vertex; vertices take
/// the carved height of their layer rounded to 2^-10 m; error_m and border_error_m, squared and added, <= tolerance_m
/// squared, but for what a further vertex could not mend; then diagnosed kToleranceNotMet. Cost: n log n in border
/// segments and inserted samples.
GroundMesh generate_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell,
                         double tolerance_m, Report& report);

/// The same of a cell that is known.
/// @param normals  Of the graded terrain that it is known from; those of one level serve the next.
GroundMesh generate_cell(const PreparedCell& known, GradedNormals& normals, double tolerance_m, Report& report);

/// The same beside cells that are finer.
/// @param sides_m  The tolerance at each side: the cell's own, or the neighbour's where that is smaller. So both have
///                 the same vertices there.
GroundMesh generate_cell(const PreparedCell& known, GradedNormals& normals, double tolerance_m,
                         const SideTolerances& sides_m, Report& report);

/// What generate_cell is certified against: the graded terrain of the cell, linear on the faces of one triangulation.
Reference reference_of_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell);

}  // namespace citykiln::ground

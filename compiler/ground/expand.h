// The ground: one conforming constrained triangulation per cell, every face of one surface, with a certified vertical
// error against the carved ground.
//
//   1. the borders of all surfaces, the lines along which the carved ground bends and the cell's own border become one
//      arrangement on the 2^-10 m grid; triangulated, with the carved heights at its vertices, it is the reference
//   2. its faces learn what covers them by counting the rings they are inside of; borders between equal faces are
//      forgotten
//   3. thin faces yield to their neighbours and borders are simplified, both to a share of the tolerance
//   4. what is left is split where the height along it would be off by more than the tolerance
//   5. a constrained Delaunay triangulation takes points of the reference until no face is off by more than the
//      tolerance
//   6. where surfaces of different layers meet at different heights, upright faces close the step
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
#include "compiler/ground/cover/surface_map.h"
#include "compiler/ground/cover/yield_slivers.h"
#include "compiler/ground/grading/carved_normals.h"
#include "compiler/ground/grading/carving.h"
#include "compiler/ground/mesh/reference.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

struct GroundMesh {
  Mesh mesh;  ///< Upwards, then upright faces; positions on the 2^-10 m grid; normals of the carved ground.
  std::vector<std::uint32_t> face_surface;  ///< One a triangle: index into the surfaces given, or kNoSurface.
  std::uint32_t first_upright = 0;          ///< Triangles from here on stand upright: kerbs, quays, walls.
  double border_error_m = 0;  ///< Largest distance in plan between borders and what they stand for, both ways.
  double error_m = 0;  ///< Largest vertical distance between mesh and carved ground, layer by layer: measured at all
                       ///< vertices of their overlay, so exact.
};

/// What a cell is made of before any tolerance.
struct KnownCell {
  std::vector<FaceHeight> heights;  ///< One a surface.
  Regions between_borders;          ///< Between the borders that are seen.
  std::vector<RimPiece> rim;        ///< Where they run along the cell's own.
  Reference reference;              ///< What heights are measured against.
};

/// The dearer half of expand_cell: levels that share surfaces and carving share this too. Parameters as there; what is
/// returned refers to the carving.
KnownCell know_cell(std::span<const Surface> surfaces, const Carving& carving, const Box2& cell);

/// The ground of one cell.
///
/// @param surfaces     All that touch the cell, trimmed or not (map of roads, areas, footprints); others are ignored.
/// @param carving      Of all that is within its reach of the cell.
/// @param cell         Corners on whole metres.
/// @param tolerance_m  > 0.
/// Guarantees: triangles that are not upright are counter-clockwise from above, they tile the cell exactly (sum of plan
/// areas equals the cell's); each inner edge has two faces, or an upright one between them; border vertices depend only
/// on surfaces and heights that touch the border, so cells made apart meet vertex for vertex; vertices take the carved
/// height of their layer rounded to 2^-10 m; error_m and border_error_m, squared and added, <= tolerance_m squared, but
/// for what a further vertex could not mend; then diagnosed kToleranceNotMet. Cost: n log n in border segments and
/// inserted samples.
GroundMesh expand_cell(std::span<const Surface> surfaces, const Carving& carving, const Box2& cell, double tolerance_m,
                       Report& report);

/// The same of a cell that is known.
/// @param normals  Of the carving that it is known from; those of one level serve the next.
GroundMesh expand_cell(const KnownCell& known, CarvedNormals& normals, double tolerance_m, Report& report);

/// The same beside cells that are finer.
/// @param sides_m  The tolerance at each side: the cell's own, or the neighbour's where that is smaller. So both have
///                 the same vertices there.
GroundMesh expand_cell(const KnownCell& known, CarvedNormals& normals, double tolerance_m,
                       const SideTolerances& sides_m, Report& report);

/// What expand_cell is certified against: the carved ground of the cell, linear on the faces of one triangulation.
Reference reference_of_cell(std::span<const Surface> surfaces, const Carving& carving, const Box2& cell);

}  // namespace citykiln::ground

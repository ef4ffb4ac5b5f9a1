// Generates the ground mesh of one cell: a constrained triangulation in which every face belongs to one land cover
// polygon, with a measured (exact) vertical error against the graded terrain.
//
//   1. the borders of all land cover, the lines along which the graded terrain bends and the cell's border become one
//      arrangement on the 2^-10 m grid; triangulated, with graded heights at its vertices, it is the reference
//   2. the faces of the arrangement are labelled with what covers them; borders between equal faces are dropped
//   3. thin faces are merged into neighbours and borders simplified, both to a share of the tolerance
//   4. borders are split where the height along them would be off by more than the tolerance
//   5. a constrained Delaunay triangulation takes points of the reference until no face is off by more; where there is
//      no room for a point it gets edges of the reference
//   6. vertical faces join faces of different height layers
//
// ground.md explains why neighbouring cells fit byte for byte and why the error is exact.
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
#include "compiler/ground/mesh/layered_mesh.h"
#include "compiler/ground/mesh/reference.h"
#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// The part of a cell that no tolerance changes.
struct PreparedCell {
  std::vector<FaceHeight> heights;           ///< One per land cover polygon.
  Regions between_borders;                   ///< The regions between visible borders.
  std::vector<CellBorderPiece> cell_border;  ///< Where visible borders run along the cell's own.
  Reference reference;                       ///< Heights are measured against it.
};

/// Prepares a cell: the more expensive half of generate_cell(). Levels with the same land cover and graded terrain
/// share it. Parameters as in generate_cell(). The result refers to `graded`.
PreparedCell prepare_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell);

/// Generates the ground of one cell.
///
/// @param surfaces     All polygons that touch the cell, trimmed or not. Others are ignored.
/// @param graded       Made of all recipes within kGrading_m of the cell.
/// @param cell         Corners on whole metres.
/// @param tolerance_m  > 0.
/// Guarantees: faces that are not vertical are counter-clockwise from above and tile the cell exactly (their plan areas
/// add up to the cell's); an inner edge has two faces, or a vertical one between them; vertices on the cell's border
/// depend only on what touches the border, so cells generated apart meet vertex for vertex; a vertex has its layer's
/// graded height, rounded to 2^-10 m; error_m² + border_error_m² <= tolerance_m², else kToleranceNotMet is reported: no
/// further point could help. O(n log n) in border segments and inserted points.
GroundMesh generate_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell,
                         double tolerance_m, Report& report);

/// Generates a level of a prepared cell.
/// @param normals  Of the graded terrain the cell was prepared from; levels share it.
GroundMesh generate_cell(const PreparedCell& prepared, GradedNormals& normals, double tolerance_m, Report& report);

/// Generates a level of a prepared cell beside neighbours with other tolerances.
/// @param sides_m  One tolerance per side: the smaller of both cells', so both have the same vertices there.
GroundMesh generate_cell(const PreparedCell& prepared, GradedNormals& normals, double tolerance_m,
                         const SideTolerances& sides_m, Report& report);

/// Returns what generate_cell() measures its error against: the cell's graded terrain, linear on the faces of one
/// triangulation.
Reference reference_of_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell);

}  // namespace citykiln::ground

// Generates the ground mesh of one cell: a constrained triangulation in which every face belongs to one land cover
// polygon, with a measured (exact) vertical error against the graded terrain.
//
//   1. the borders of all land cover, the lines along which the graded terrain bends and the cell's border become one
//      arrangement on the 2^-10 m grid; triangulated, with graded heights at its vertices, it is the reference
//   2. the faces of the arrangement are labelled with their land cover; borders between equal faces are dropped
//   3. thin faces are merged into neighbours and borders simplified, both to a share of the tolerance
//   4. borders are split until the height along them is within the tolerance
//   5. points of the reference are inserted into a constrained Delaunay triangulation until all faces are within the
//      tolerance; if there is no room for a point, edges of the reference are inserted
//   6. vertical faces join faces of different height layers
//
// ground.md explains why neighbouring cells fit byte for byte and why the error is exact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
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

/// The data of a cell that do not depend on the tolerance. A cell is a square of ground that is meshed on its own.
struct PreparedCell {
  std::vector<FaceHeight> heights;           ///< One per land cover polygon.
  std::vector<Border> borders;               ///< The visible borders.
  CoverFaces faces_between_borders;          ///< The faces between these borders, straightened.
  double straightened_m;                     ///< The largest distance by which straightening moved a border.
  std::vector<CellBorderPiece> cell_border;  ///< Pieces of the cell's border along which visible borders run.
  Reference reference;                       ///< The triangulation against which heights are measured.
};

/// Prepares a cell: the more expensive half of generate_cell(). Levels with the same land cover and graded terrain
/// share it. Parameters as in generate_cell(). The result refers to `graded`, which must outlive it.
PreparedCell prepare_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell);

/// Generates the ground of one cell.
///
/// @param surfaces     All polygons that touch the cell, trimmed or not. Others are ignored.
/// @param graded       The terrain graded with all recipes within kGrading_m of the cell.
/// @param cell         A box with corners on whole metres.
/// @param tolerance_m  > 0.
/// Guarantees: faces that are not vertical are counter-clockwise from above and tile the cell exactly (their plan areas
/// add up to the cell's); an inner edge has two faces, or a vertical one between them; vertices on the cell's border
/// depend only on recipes that touch the border, so cells generated separately meet vertex for vertex; a vertex has its
/// layer's graded height, rounded to 2^-10 m; error_m² + border_error_m² <= tolerance_m². If no further point could
/// achieve that, kToleranceNotMet is reported. O(n log n) in border segments and inserted points.
GroundMesh generate_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell,
                         double tolerance_m, Report& report);

/// Generates a level of a prepared cell.
/// @param normals  Normals of the graded terrain from which the cell was prepared; levels share it.
GroundMesh generate_cell(const PreparedCell& prepared, GradedNormals& normals, double tolerance_m, Report& report);

/// Generates a level of a prepared cell beside neighbours with other tolerances.
/// @param sides_m  One tolerance per side: the smaller one of both cells, so that both have the same vertices there.
GroundMesh generate_cell(const PreparedCell& prepared, GradedNormals& normals, double tolerance_m,
                         const SideTolerances& sides_m, Report& report);

/// Returns the reference against which generate_cell() measures its error: the cell's graded terrain, linear on the
/// faces of one triangulation. It refers to `graded`, which must outlive it.
Reference reference_of_cell(std::span<const LandCoverPolygon> surfaces, const GradedTerrain& graded, const Box2& cell);

}  // namespace citykiln::ground

// Generates the ground of a tile cell by cell. A cell is a square of map::kCell_m (128 m).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/generate.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The cells of a tile's box, by column, then row. The box is a whole number of cells.
std::vector<Box2> cells_of(const Box2& tile);

/// The inputs of a tile's ground at one of several tolerances (levels of detail).
struct GroundLevel {
  const ground::GradedTerrain& graded;                 ///< The terrain after roads and water have cut into it.
  std::span<const ground::LandCoverPolygon> surfaces;  ///< The land cover.
  double tolerance_m;
};

/// The reference of each cell, in the order of cells_of(): the ground at full detail, against which errors are
/// certified. Levels may share references. They refer to the level's graded terrain.
using CellReferences = std::vector<std::shared_ptr<const ground::Reference>>;

/// Generates the ground of each cell for all levels. Returns one list per level, in the order of cells_of(). Levels
/// with the same graded terrain share work on a cell if their surfaces near it are equal; this changes no byte.
///
/// @param reports     One per level.
/// @param references  One per level, to receive the references of its cells; or empty to discard these.
///
/// Memory: the references of one cell per thread, the meshes of all levels, and the references that are kept.
std::vector<std::vector<ground::GroundMesh>> generate_cells(std::span<const GroundLevel> levels, const Box2& tile,
                                                            int threads, std::span<Report> reports,
                                                            std::span<CellReferences> references = {});

/// Generates the ground of each cell of one level.
std::vector<ground::GroundMesh> generate_cells(const ground::GradedTerrain& graded,
                                               std::span<const ground::LandCoverPolygon> surfaces, const Box2& tile,
                                               double tolerance_m, int threads, Report& report);

/// A cell with its tolerance and the tolerances along its four sides.
struct CellLevel {
  Box2 cell;
  double tolerance_m;
  ground::SideTolerances sides_m;
};

/// Generates the ground of some cells of a tile, each at its own tolerance.
std::vector<ground::GroundMesh> generate_cells(const ground::GradedTerrain& graded,
                                               std::span<const ground::LandCoverPolygon> surfaces,
                                               std::span<const CellLevel> cells, int threads, Report& report);

}  // namespace citykiln::bake

// Generates the ground of a tile, cell by cell.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/generate.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The cells of a tile's box, by column, then row. The box is a whole number of cells.
std::vector<Box2> cells_of(const Box2& tile);

/// The inputs of a tile's ground at one level of a ladder.
struct GroundLevel {
  const ground::GradedTerrain& graded;
  std::span<const ground::LandCoverPolygon> surfaces;
  double tolerance_m;
};

/// The reference triangulations against which the errors of a level's cells are certified, in the order of cells_of().
/// Levels may share them. They refer to the graded terrain of the level.
using CellReferences = std::vector<std::shared_ptr<const ground::Reference>>;

/// Generates the ground of each cell, in the order of cells_of(), level by level. Levels with the same graded terrain
/// share the arrangement of a cell if their surfaces near it are equal, which saves time and changes no byte.
///
/// @param reports     One per level.
/// @param references  One per level, to receive the references of its cells; or empty to discard these.
/// Memory: one cell's arrangement per thread, the meshes of all levels, and the references that are kept.
std::vector<std::vector<ground::GroundMesh>> generate_cells(std::span<const GroundLevel> levels, const Box2& tile,
                                                            int threads, std::span<Report> reports,
                                                            std::span<CellReferences> references = {});

/// Generates the ground of each cell of one level.
std::vector<ground::GroundMesh> generate_cells(const ground::GradedTerrain& graded,
                                               std::span<const ground::LandCoverPolygon> surfaces, const Box2& tile,
                                               double tolerance_m, int threads, Report& report);

/// A cell with its tolerance and those of its sides.
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

// The ground of a tile: all its cells.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/generate.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The cells of a tile's box, by column, then row.
std::vector<Box2> cells_of(const Box2& tile);

/// What the ground of a tile is at one level of a ladder.
struct GroundLevel {
  const ground::GradedTerrain& graded;
  std::span<const ground::LandCoverPolygon> surfaces;
  double tolerance_m;
};

/// The ground of each cell, in the order of cells_of, level by level. Levels with one carving share what a cell knows
/// where their surfaces near it are equal: the same bytes as level after level, in less time.
/// @param reports  One a level.
/// Memory: one cell's knowledge a thread, and the meshes of all levels.
std::vector<std::vector<ground::GroundMesh>> generate_cells(std::span<const GroundLevel> levels, const Box2& tile,
                                                            int threads, std::span<Report> reports);

/// One level of them.
std::vector<ground::GroundMesh> generate_cells(const ground::GradedTerrain& graded,
                                               std::span<const ground::LandCoverPolygon> surfaces, const Box2& tile,
                                               double tolerance_m, int threads, Report& report);

/// A cell, and how fine it is made.
struct CellLevel {
  Box2 cell;
  double tolerance_m;
  ground::SideTolerances sides_m;
};

/// The ground of some cells of a tile, each at its own level.
std::vector<ground::GroundMesh> generate_cells(const ground::GradedTerrain& graded,
                                               std::span<const ground::LandCoverPolygon> surfaces,
                                               std::span<const CellLevel> cells, int threads, Report& report);

/// What each of a tile's cells is certified against, in the order of cells_of.
std::vector<ground::Reference> reference_cells(const ground::GradedTerrain& graded,
                                               std::span<const ground::LandCoverPolygon> surfaces, const Box2& tile,
                                               int threads);

}  // namespace citykiln::bake

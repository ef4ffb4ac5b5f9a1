// The ground of a tile: all its cells.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/expand.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The cells of a tile's box, by column, then row.
std::vector<Box2> cells_of(const Box2& tile);

/// The ground of each cell, in the order of cells_of.
std::vector<ground::GroundMesh> expand_cells(const ground::Carving& carving, std::span<const ground::Surface> surfaces,
                                             const Box2& tile, double tolerance_m, int threads, Report& report);

/// What each of them is certified against, in the same order.
std::vector<ground::Reference> reference_cells(const ground::Carving& carving,
                                               std::span<const ground::Surface> surfaces, const Box2& tile,
                                               int threads);

}  // namespace citykiln::bake

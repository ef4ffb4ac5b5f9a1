// The ground of a tile: all its cells, dressed.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/expand.h"
#include "compiler/materials/dressed_mesh.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// The cells of a tile's box, by column, then row.
std::vector<Box2> cells_of(const Box2& tile);

/// The ground of each cell, in the order of cells_of.
std::vector<ground::GroundMesh> expand_cells(const scene::Chunk& chunk, std::span<const ground::Surface> surfaces,
                                             const Box2& tile, double tolerance_m, int threads, Report& report);

/// A cell's ground as one mesh a surface, tinted by (seed, surface).
std::vector<materials::DressedMesh> dress(const ground::GroundMesh& ground, std::span<const ground::Surface> surfaces,
                                          std::uint64_t seed);

}  // namespace citykiln::bake

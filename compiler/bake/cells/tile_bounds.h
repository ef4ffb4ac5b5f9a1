// Bounds of a baked tile that are known before it is baked.
#pragma once

#include "compiler/bake/bounds.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Returns bounds of the meshes and instances of bake() at a tolerance, skirts included, from the recipes alone: those
/// of cell_bounds() (bake_cell.h) of all cells of the tile. Cost: O(recipes), about a thousandth of baking the tile.
///
/// @param tolerance_m  > 0.
Bounds tile_bounds(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m);

}  // namespace citykiln::bake

// Buildings of a tile at tolerances with Detail::kBlocks: as blocks.
#pragma once

#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Adds blocks to the tile and certifies their error. A block has the material that most of its buildings' walls or
/// roofs have, by area, and their mean colour; its feature is its building's if it has only one, else none. Buildings
/// of blocks that are left out are dropped by kBelowTolerance, others are counted as merged.
/// @param level  With its ground. The tile is whole: views have no blocks.
void bake_blocks(Baking& baking, const TileLevel& level, const buildings::Rulebook& rulebook, int threads,
                 Report& report);

}  // namespace citykiln::bake

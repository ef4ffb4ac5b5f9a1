// Bakes the buildings of a tile as blocks: simplified bodies that each stand for several neighbouring buildings.
// Tolerances with Detail::kBlocks have blocks.
#pragma once

#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Adds blocks to the tile, and their errors to its error. The walls and the roofs of a block have the material with
/// the largest area on its buildings, and its mean colour. A block of one building has that building's feature, other
/// blocks have none. Buildings of blocks that are left out are dropped, kBelowTolerance; others are counted as merged.
/// @param level     A level of a whole tile, with its ground. Tiles for a viewpoint have no blocks.
/// @param rulebook  The parsed rules of building styles.
void bake_blocks(Baking& baking, const TileLevel& level, const buildings::Rulebook& rulebook, int threads,
                 Report& report);

}  // namespace citykiln::bake

// Bakes the ground of a tile, and bridges and tunnels, which share its marking atlas.
#pragma once

#include <vector>

#include "compiler/bake/bake_structures.h"
#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Adds the ground of the level's cells (128 m squares) with materials and skirts, then the structures. If the tile has
/// markings, it gets the atlas TileLevel::markings or, if that is null, an atlas of its own markings. A single cell
/// gets no atlas.
/// @param structures  Result of generate_structures().
void bake_ground(Baking& baking, const TileLevel& level, std::vector<GeneratedSpan> structures);

}  // namespace citykiln::bake

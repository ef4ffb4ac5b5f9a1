// The ground of a tile, with bridges and tunnels, which share its marking atlas.
#pragma once

#include <vector>

#include "compiler/bake/bake_structures.h"
#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Adds the level's cells with their materials and skirts, then the structures, and draws the tile's marking atlas: the
/// ground's marking layouts first, then the structures'.
void bake_ground(Baking& baking, TileLevel& level, std::vector<Built> structures);

}  // namespace citykiln::bake

// The ground of a tile, with bridges and tunnels, which share its marking atlas.
#pragma once

#include <vector>

#include "compiler/bake/bake_structures.h"
#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Adds the level's cells with their materials and skirts, then the structures. The tile gets the marking atlas of the
/// level's markings if it shows any; without these an atlas of all that it shows is drawn. Cells get none.
void bake_ground(Baking& baking, const TileLevel& level, std::vector<Built> structures);

}  // namespace citykiln::bake

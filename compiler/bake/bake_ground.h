// Bakes the ground of a tile, and bridges and tunnels, which share its marking atlas.
#pragma once

#include <vector>

#include "compiler/bake/bake_structures.h"
#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Adds the level's cells with their materials and skirts, then the structures. A tile that shows markings gets the
/// atlas of TileLevel::markings, or, without these, an atlas of its own markings. Single cells get no atlas.
void bake_ground(Baking& baking, const TileLevel& level, std::vector<Built> structures);

}  // namespace citykiln::bake

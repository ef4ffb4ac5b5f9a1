// The houses of a tile: levels that show facades as pictures share what these are made of, and a tile has one atlas.
#pragma once

#include <span>

#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// The houses of those levels that show facades as pictures. The others' are made when they are fired.
void generate_textured_buildings(const scene::Header& header, const scene::Chunk& chunk, std::span<TileLevel> levels,
                                 int threads);

/// Account "bake/building".
void bake_buildings(Baking& baking, TileLevel& level, int threads, Report& report);

}  // namespace citykiln::bake

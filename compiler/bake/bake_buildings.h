// The houses of a tile: levels that show facades as pictures share what these are made of, and a tile has one atlas.
#pragma once

#include <span>

#include "compiler/bake/baking.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// The houses of those levels that show facades as pictures. The others' are made when they are fired.
/// @param rulebook  Parsed from the header's rules.
void generate_textured_buildings(const scene::Header& header, const scene::Chunk& chunk,
                                 const buildings::Rulebook& rulebook, std::span<TileLevel> levels, int threads);

/// Account "bake/building".
void bake_buildings(Baking& baking, TileLevel& level, const buildings::Rulebook& rulebook, int threads, Report& report);

}  // namespace citykiln::bake

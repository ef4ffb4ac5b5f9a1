// Bakes the buildings of a tile. Levels with facade textures render them from meshes that all these levels share; all
// textures of a level are on one atlas.
#pragma once

#include <span>

#include "compiler/bake/baking.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// Sets TileLevel::buildings of all levels with Detail::kFacadeTextures: the meshes of the chunk's buildings, with
/// their textures. Other levels generate theirs when they are baked. The result does not depend on `threads`. Cost:
/// that of generating the buildings once in full, and of drawing the textures.
/// @param shared  Has the header's rules and the pictures of elements.
void generate_textured_buildings(const scene::Header& header, const scene::Chunk& chunk, const PrototypeCache& shared,
                                 std::span<TileLevel> levels, int threads);

/// Adds the buildings of a level to the tile that is baked: those in TileLevel::buildings, which are moved from, else
/// generated ones. Whole tiles with Detail::kBlocks get merged blocks instead. Ledger "bake/building".
void bake_buildings(Baking& baking, TileLevel& level, const PrototypeCache& shared, int threads, Report& report);

}  // namespace citykiln::bake

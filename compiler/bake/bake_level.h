// Bakes one level of a tile from its ground and recipes: what all forms of baking have in common.
#pragma once

#include "compiler/bake/baked_cell.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// What is baked at a level.
struct LevelRequest {
  const scene::Header& header;
  const scene::Chunk& chunk;         ///< Of a cell: its objects alone.
  const TilePart* part = nullptr;    ///< Null: the whole tile.
  const CellBaking* cell = nullptr;  ///< Null: the whole tile or part; else plants are put there (baked_cell.h).
  std::size_t most_instances;
};

/// Bakes a level. The report gets what the tolerance drops.
BakedTile bake_level(const LevelRequest& request, TileLevel& level, const PrototypeCache& prototypes, int threads,
                     Report& report);

}  // namespace citykiln::bake

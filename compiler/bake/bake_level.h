// Bakes one level of detail of a tile from its generated ground and the recipes of its objects. All functions of bake.h
// and bake_cell.h use it.
#pragma once

#include "compiler/bake/baked_cell.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/tile_levels.h"

namespace citykiln::bake {

/// The objects to bake at a level.
struct LevelRequest {
  const scene::Header& header;
  const scene::Chunk& chunk;         ///< For a cell, a chunk with the cell's objects only.
  const TilePart* part = nullptr;    ///< The part of a view; null: the whole tile.
  const CellBaking* cell = nullptr;  ///< The cell, which gets the plants (baked_cell.h); null: a whole tile or part.
  std::size_t most_instances;        ///< If the tile has more instances, many of its plants become meshes (stands.h).
};

/// Bakes a level. Objects smaller than the tolerance are dropped and reported. The result's positions are metres from
/// its origin, which is in plane metres. The result owns its data and refers to no argument.
///
/// @param level  The level's ground. Its buildings are generated if it has none yet. Their meshes are moved into the
///               result, so a level can be baked only once.
BakedTile bake_level(const LevelRequest& request, TileLevel& level, const PrototypeCache& prototypes, int threads,
                     Report& report);

}  // namespace citykiln::bake

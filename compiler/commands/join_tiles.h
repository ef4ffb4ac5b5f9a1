// Joins several baked tiles of one tolerance to one tile, to have a whole map in one file.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Guarantees: triangles and instances keep their exact places; one primitive for each key; each shows the texels of
/// its own tile's atlases, which are joined (join_marking_atlases.h, join_facade_atlases.h); the error is the largest
/// of all.
/// @param tiles  At least one. The joined tile has the name of the first; its origin is the lowest corner of all.
/// Errors: tiles over more than 16 km, where float32 is no longer exact; marking atlases that cannot be joined.
/// O(vertices).
Result<bake::BakedTile> join_tiles(std::span<const bake::BakedTile> tiles);

}  // namespace citykiln::commands

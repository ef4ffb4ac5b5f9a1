// Several baked tiles of one tolerance as one, for who wants a whole place in one file.
#pragma once

#include <span>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Guarantees: the same triangles and instances at the same places, exactly; one primitive a key, each showing its
/// own tile's sheet and atlas, of which the joined ones are made (join_sheets.h, join_atlases.h); the largest error of
/// all.
/// @param tiles  At least one. Named after the first; its origin is the lowest corner of all.
/// Errors: tiles that lie farther apart than float32 is exact for (16 km); sheets that cannot be one. O(vertices).
Result<bake::BakedTile> join_tiles(std::span<const bake::BakedTile> tiles);

}  // namespace citykiln::commands

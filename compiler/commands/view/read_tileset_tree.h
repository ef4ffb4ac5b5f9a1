// Reads tileset.json, and the tilesets that it refers to, into a tree of tiles.
#pragma once

#include <string>

#include "compiler/commands/view/tile_tree.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Reads a tileset of the form that `compile --emit 3dtiles` writes: refinement by replacement, explicit tiles, boxes,
/// contents that are .glb files. The frame is that of the tileset's root without its transform to the Earth: east,
/// north and up at the origin of the run, with heights above the ellipsoid.
///
/// Errors: a file that cannot be read or is not such a tileset; names outside its folder.
/// @param folder  The folder that contains tileset.json.
Result<TileNode> read_tileset_tree(const std::string& folder);

}  // namespace citykiln::commands

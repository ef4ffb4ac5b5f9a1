// Reads tileset.json and the tilesets that it names into a tree of tiles.
#pragma once

#include <string>

#include "compiler/commands/tile_tree.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Reads a tileset as `compile --emit 3dtiles` writes it: refinement by replacement, explicit tiles, boxes, contents
/// that are .glb files. Frame: that of the tileset's root, without its transform to the Earth: east, north and up at
/// the origin of the run, heights above the ellipsoid.
///
/// Errors: a file that cannot be read or is no such tileset; names outside of its folder.
/// @param folder  That contains tileset.json.
Result<TileNode> read_tileset_tree(const std::string& folder);

}  // namespace citykiln::commands

// Reads the 3D Tiles of the regions of a plan, and joins them to one tree. A region is a part of the map that was
// compiled on its own.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::commands {

/// Reads a tileset that write_tiles3d() wrote, with the tilesets that it refers to.
/// @param folder  The folder that contains tileset.json.
/// @param prefix  Is put before the names of contents in the result.
/// Errors: a file that cannot be read or is not such a tileset.
Result<exporters::TilesetTile> read_region_tileset(const std::string& folder, const std::string& prefix);

/// Returns a tile without content whose children are the given trees, so that all of them are shown. Its geometric
/// error is twice the largest error of its children.
/// @param trees  Not empty; a single tree is returned unchanged.
exporters::TilesetTile joined_trees(std::vector<exporters::TilesetTile>&& trees);

}  // namespace citykiln::commands

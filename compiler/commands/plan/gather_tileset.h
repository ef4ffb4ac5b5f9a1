// Joins the tilesets of regions to one tileset.
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
Result<exporters::TilesetTile> read_tileset(const std::string& folder, const std::string& prefix);

/// Returns a root without content above several trees, so that all are shown. Its error is twice the largest of theirs.
/// @param trees  Not empty; a single tree is returned unchanged.
exporters::TilesetTile joined_trees(std::vector<exporters::TilesetTile>&& trees);

}  // namespace citykiln::commands

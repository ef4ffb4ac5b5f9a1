// Joins the tilesets of regions to one.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::commands {

/// Reads a tileset that write_tiles3d() wrote, with the tilesets that it names.
/// @param folder  That contains tileset.json.
/// @param prefix  Before the names of contents in the result.
/// Errors: a file that cannot be read or is no such tileset.
Result<exporters::TilesetTile> read_region_tileset(const std::string& folder, const std::string& prefix);

/// A root without content above several trees, which are shown together. Its error is twice their largest.
/// @param trees  Not empty; one tree is returned as it is.
exporters::TilesetTile joined_trees(std::vector<exporters::TilesetTile>&& trees);

}  // namespace citykiln::commands

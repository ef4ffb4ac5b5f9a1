// Reads the USD scene of a region, so that one scene can be written for all regions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "exporters/usd/encode_scene.h"

namespace citykiln::commands {

/// Reads the tiles of a scene layer that encode_scene() wrote, with their places and the bounds of their finest level.
/// Errors: a file that cannot be read; a layer that lacks one of the tiles.
Result<std::vector<exporters::UsdTile>> read_usd_tiles(const std::string& path, std::span<const scene::TileKey> tiles);

}  // namespace citykiln::commands

// The names of prims and files in USD outputs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// Returns the name of a tile's prim in the scene. Names cannot contain "-": tile -3_17 is "tile_m3_17".
std::string usd_tile_prim(scene::TileKey tile);

/// Returns an identifier: characters other than letters, digits and underscores become underscores, and no digit is
/// first.
std::string usd_identifier(std::string_view text);

/// Returns the path of a tile's layer, "usd/tiles/3_-2.usda", or of a level's layer, "usd/tiles/3_-2_L0.usdc".
std::string usd_tile_name(scene::TileKey tile);
std::string usd_level_name(scene::TileKey tile, std::size_t level);

}  // namespace citykiln::exporters

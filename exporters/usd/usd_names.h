// Names of prims and files of USD outputs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// The name of a tile's prim in the scene, where "-" is not allowed: "tile_m3_17" of tile -3_17.
std::string usd_tile_prim(scene::TileKey tile);

/// An identifier: letters, digits and underscores, others replaced by an underscore, no digit first.
std::string usd_identifier(std::string_view text);

/// "usd/tiles/3_-2.usda" and "usd/tiles/3_-2_L0.usdc".
std::string usd_tile_name(scene::TileKey tile);
std::string usd_level_name(scene::TileKey tile, std::size_t level);

inline constexpr const char* kUsdSceneName = "usd/scene.usda";
inline constexpr const char* kUsdSurroundingsName = "usd/surroundings.usdc";
inline constexpr const char* kUsdTextureFolder = "usd/textures/";

}  // namespace citykiln::exporters

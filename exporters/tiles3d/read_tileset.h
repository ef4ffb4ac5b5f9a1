// Reads tilesets that encode_tileset() wrote.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::exporters {

/// The contents of one file of a tileset.
struct ReadTileset {
  TilesetTile root{};               ///< A tile that refers to another tileset has the tileset's name as content.
  double error_m = 0;               ///< The error if no tile is shown; 0 if the file states none.
  std::vector<double> transform{};  ///< The transform of the root; empty if it has none.
  std::string attribution{};        ///< asset.extras.copyright; empty if the file has none.
};

/// Reads one file. Does not check that boxes contain those of their children or that errors decrease.
///
/// Errors: bytes that are not JSON, or tiles unlike those of encode_tileset(), which have version 1.1, boxes, errors of
/// 0 or more, refinement by replacement, a transform of the root only, .glb or .json files below the tileset's folder
/// as contents, and at most 64 levels.
/// @param name  The name of the file in error messages.
Result<ReadTileset> decode_tileset(std::string_view json, const std::string& name);

/// Reads tileset.json and the tilesets that it refers to, and puts their roots in the places of the tiles that refer
/// to them. Errors: those of decode_tileset(); a file that cannot be read; a tileset that is referred to twice.
/// @param folder  The folder that contains tileset.json.
Result<TilesetTile> read_tileset(const std::string& folder);

}  // namespace citykiln::exporters

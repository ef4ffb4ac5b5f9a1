// Reads tilesets that encode_tileset() wrote.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::exporters {

/// What one file of a tileset says.
struct ReadTileset {
  TilesetTile root{};               ///< Tiles that name another tileset have its name as content.
  double error_m = 0;               ///< Of the tileset without any tile; 0 where it has none.
  std::vector<double> transform{};  ///< Of the root; empty where it has none.
  std::string attribution{};        ///< asset.extras.copyright; empty where it has none.
};

/// Reads one file. Boxes are as their rounded numbers say, and need not contain each other; errors need not fall.
///
/// Errors, in one line: no JSON, or no tiles as encode_tileset() writes them: version 1.1, boxes, errors of 0 or more,
/// refinement by replacement, a transform of the root alone, contents that are .glb or .json files below the tileset's
/// folder, at most 64 levels.
/// @param name  The file's name in error messages.
Result<ReadTileset> decode_tileset(std::string_view json, const std::string& name);

/// Reads tileset.json and the tilesets that it names, each root in the place of the tile that names it. Errors: as
/// decode_tileset(); a file that cannot be read; a tileset that is named twice.
/// @param folder  That contains tileset.json.
Result<TilesetTile> read_tileset(const std::string& folder);

}  // namespace citykiln::exporters

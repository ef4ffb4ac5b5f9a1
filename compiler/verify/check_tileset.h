// Checks the 3D Tiles of a run: the tree of its tilesets, and places on the globe by GeographicLib.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/check_tile.h"
#include "exporters/tiles3d/oriented_box.h"

namespace citykiln::verify {

/// A content that a tileset names.
struct ContentReference {
  std::string uri{};             ///< Relative to the folder of tilesets.
  exporters::OrientedBox box{};  ///< Of its tile.
  double geometric_error_m = 0;
};

/// What one tileset file says.
struct ReadTileset {
  std::vector<ContentReference> contents{};  ///< .glb files.
  std::vector<ContentReference> external{};  ///< Other tilesets, with the tile that names each.
  ContentReference root{};
  std::vector<double> transform{};  ///< Of the root; empty if it has none.
  std::string attribution{};        ///< asset.extras.copyright.
};

/// Reads a tileset, and tests its structure in results.tileset, volumes in results.tileset_boxes and errors in
/// results.tileset_errors. Total: anything that is not as the specification says is a failure.
/// @param name  The file's, for failures.
ReadTileset read_tileset(const std::string& json, const std::string& name, CheckResults& results);

/// Checks the tileset of a run, all files that it names, their contents and the borders of its tiles. Does nothing for
/// a run without a tileset. Memory: a content for each thread, and the borders of all.
void check_tileset(const LoadedRun& run, int threads, CheckResults& results);

}  // namespace citykiln::verify

// Checks the 3D Tiles of a run: the tree of its tilesets, and places on the globe by GeographicLib.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/check_tile.h"
#include "exporters/tiles3d/oriented_box.h"

namespace citykiln::verify {

/// A content that a tileset refers to.
struct ContentReference {
  std::string uri{};             ///< Relative to the folder of tilesets.
  exporters::OrientedBox box{};  ///< The bounding box of its tile.
  double geometric_error_m = 0;
};

/// The parts of one tileset file that are checked.
struct CheckedTileset {
  std::vector<ContentReference> contents{};  ///< .glb files.
  std::vector<ContentReference> external{};  ///< Other tilesets, with the tile that refers to each.
  ContentReference root{};                   ///< Without a uri.
  std::vector<double> transform{};           ///< The transform of the root; empty if it has none.
  std::string attribution{};                 ///< asset.extras.copyright.
};

/// Reads a tileset and tests its structure in results.tileset, volumes in results.tileset_boxes and errors in
/// results.tileset_errors. Cannot fail: every deviation from the specification is a failure in the results.
/// @param name  The file's name, for failures.
CheckedTileset check_tileset_file(const std::string& json, const std::string& name, CheckResults& results);

/// Checks the tileset of a run, all files that it refers to, their contents and the borders of its tiles. Does nothing
/// for a run without a tileset. Memory: one content per thread, and the borders of all.
void check_tileset(const LoadedRun& run, int threads, CheckResults& results);

}  // namespace citykiln::verify

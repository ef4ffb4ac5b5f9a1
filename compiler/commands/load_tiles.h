// Baked tiles from whichever form is given: fired from a manifest, or read from .glb files or from a run's folder.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/stage_timer.h"

namespace citykiln::commands {

struct LoadRequest {
  std::vector<std::string> paths;    ///< One .kiln, or one folder of a run, or .glb files.
  std::string time;                  ///< At which a manifest is fired; "": the scene's.
  double tolerance_m = 0.1;          ///< Of what a manifest is fired at.
  std::size_t level = 0;             ///< Of a folder's tiles.
  std::vector<scene::TileKey> only;  ///< If not empty, only these tiles.
  int threads = 0;
};

struct Loaded {
  std::vector<bake::BakedTile> tiles;   ///< Sorted by tile.
  std::optional<scene::Header> header;  ///< From the manifest: the one given, or the one beside the .glb files' folder.
};

/// Errors: files that cannot be read, a folder without that level, no tile at all, forms mixed.
Result<Loaded> load_tiles(const LoadRequest& request, const OnProgress& on_progress);

}  // namespace citykiln::commands

// Loads baked tiles: by baking a manifest, or by reading .glb files or a run's folder.
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
  std::vector<std::string> paths;     ///< One .kiln, or one folder of a run, or .glb files.
  std::string time;                   ///< Time of the sky for baking a manifest; "": the scene's.
  sky::AirSettings air;               ///< What of it replaces the scene's.
  std::optional<double> tolerance_m;  ///< For baking a manifest; none: 0.1 m.
  std::size_t level = 0;              ///< Of a folder's tiles.
  std::vector<scene::TileKey> only;   ///< If not empty, only these tiles.
  int threads = 0;
};

struct Loaded {
  std::vector<bake::BakedTile> tiles;  ///< Sorted by tile.
  std::optional<scene::Header>
      header;  ///< Of the given manifest, or of the manifest beside the folder of the .glb files.
};

/// Errors: files that cannot be read, a folder without the requested tiles and level, mixed kinds of input.
Result<Loaded> load_tiles(const LoadRequest& request, const OnProgress& on_progress);

}  // namespace citykiln::commands

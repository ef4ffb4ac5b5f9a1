// Prepares a tile of a run, so that its files can be compared with a new bake of its recipes.
#pragma once

#include <memory>
#include <span>

#include "compiler/bake/bake.h"
#include "compiler/verify/check_tile.h"

namespace citykiln::verify {

/// The recipes of a tile, and the data that its levels share (bake_prepared() bakes one level).
struct RecipesOfTile {
  const scene::Chunk& chunk;  ///< A chunk of the run's scene.
  std::shared_ptr<bake::PreparedTile> prepared;
};

/// Returns the recipes of the tile of these files, prepared on one thread with the settings of the run, and with its
/// expected ground.
/// @param levels  The files of one tile, sorted by level; not empty.
/// Errors: a tile that the manifest does not contain.
Result<RecipesOfTile> prepare_tile(const LoadedRun& loaded, std::span<const outputs::WrittenTile> levels);

}  // namespace citykiln::verify

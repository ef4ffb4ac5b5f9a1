// Prepares a tile of a run for comparison with what its recipes give.
#pragma once

#include <memory>
#include <span>

#include "compiler/bake/bake.h"
#include "compiler/verify/check_tile.h"

namespace citykiln::verify {

/// A tile's recipes, and what its levels have in common (bake_prepared() bakes one).
struct RecipesOfTile {
  const scene::Chunk& chunk;  ///< Of the run's scene.
  std::shared_ptr<bake::PreparedTile> prepared;
};

/// Returns the recipes of the tile of some files, prepared on one thread as the run did, with its expected ground.
/// @param levels  Of one tile, sorted by level; not empty.
/// Errors: a tile that the manifest does not contain.
Result<RecipesOfTile> prepare_tile(const LoadedRun& loaded, std::span<const WrittenTile> levels);

}  // namespace citykiln::verify

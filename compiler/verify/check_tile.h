// Checks one tile of a run: compares the file of each level byte for byte with a new bake of its recipes, and measures
// the ground by its triangles.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/prototype_cache.h"
#include "compiler/contract/result.h"
#include "compiler/outputs/run_report.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/check_seams.h"

namespace citykiln::verify {

/// The outputs of a run, without the files of its tiles.
struct LoadedRun {
  std::string folder;
  outputs::RunRecord record;
  scene::Scene scene;
  std::shared_ptr<const bake::PrototypeCache> prototypes;
};

/// The results for one tile.
struct CheckedTile {
  CheckResults results;
  std::vector<Borders> borders;  ///< The borders of each level.
};

/// Checks all levels of one tile on one thread. The ground is compared at random places: a number that follows from the
/// faces of file and reference (samples_a_side()), and 512 by 512 for the reference. A reference is the ground at full
/// detail.
/// @param levels  The files of the tile, sorted by level; not empty.
/// Errors: a file that cannot be read; a tile that the manifest does not contain. Memory: one level, and the ground of
/// all levels with its references.
Result<CheckedTile> check_tile(const LoadedRun& loaded, std::span<const outputs::WrittenTile> levels);

}  // namespace citykiln::verify

// One tile of a run against its recipes: every level's file, byte for byte, and its ground by its own triangles.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/prototype_cache.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/measure_ground.h"
#include "compiler/verify/run_report.h"

namespace citykiln::verify {

/// What a run left, in memory but for the tiles.
struct LoadedRun {
  std::string folder;
  RunRecord record;
  scene::Scene scene;
  NonGroundObjects non_ground;
  std::shared_ptr<const bake::PrototypeCache> prototypes;
};

/// The edges at each side of a tile at one level, waiting for the neighbour's.
struct Borders {
  BorderEdges west, east, south, north;
};

struct CheckedTile {
  CheckResults results;
  std::vector<Borders> borders;  ///< One a level.
};

/// @param levels  The files of one tile.
/// Errors: a file that cannot be read; a tile that the manifest does not have. On one thread. Memory: one level, and
/// the ground of all.
Result<CheckedTile> check_tile(const LoadedRun& loaded, std::span<const WrittenTile> levels);

}  // namespace citykiln::verify

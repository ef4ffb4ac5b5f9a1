// Bakes the tiles of a scene in parallel and passes them on in order.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "compiler/bake/bake.h"
#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/stage_timer.h"

namespace citykiln {

/// Receives one tile at one level. An error ends baking.
using OnBakedTile = std::function<Result<Done>(const bake::BakedTile& tile, std::size_t level)>;

/// A tile at a level: an index into Scene::chunks and an index into the tolerances.
struct ChunkLevel {
  std::size_t chunk, level;
};
/// Processes a baked tile in parallel with others. Must not write to anything that two tiles share.
using ProcessTile = std::function<void(ChunkLevel at, bake::BakedTile&& tile)>;
/// Receives the tile after it was processed, with the diagnoses made while it was baked. An error ends baking.
using CollectTile = std::function<Result<Done>(ChunkLevel at, const Report& diagnosed)>;
/// True if a tile exists already. It is then not baked.
using ExistsTile = std::function<bool(ChunkLevel at)>;

/// Bakes every chunk at every tolerance and passes the tiles to `take`, one at a time, ordered by tile, then level.
/// Adds dropped objects to `report`. Errors: only those of `take`. Memory: kInFlightPerThread levels per thread, the
/// ground of their tiles, and the ground of one more tile.
///
/// @param tolerances_m    The tolerances of the levels, increasing, > 0.
/// @param most_instances  Passed to bake::prepare().
Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> tolerances_m, int threads, Report& report,
                        const OnProgress& on_progress, const OnBakedTile& take,
                        std::size_t most_instances = bake::kAnyInstances);

/// The functions that parallel baking calls for each tile and level.
struct TileHandlers {
  ExistsTile exists;    ///< Called before baking. Must always give the same answer.
  ProcessTile process;  ///< Called when a tile is baked; not for tiles that exist.
  CollectTile take;     ///< Called for all tiles in order, one at a time.
};

/// Bakes like the function above and processes tiles in parallel. If one level of a tile is baked, the tile is prepared
/// for all levels, so that no level depends on which others exist. Errors: only those of handlers.take.
Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> tolerances_m, int threads, Report& report,
                        const OnProgress& on_progress, const TileHandlers& handlers,
                        std::size_t most_instances = bake::kAnyInstances);

/// Bakes all tiles of a scene at one tolerance, in the order of its chunks. Dropped objects are not reported. Memory:
/// all tiles.
std::vector<bake::BakedTile> bake_tiles(const scene::Scene& scene, double tolerance_m, int threads);

}  // namespace citykiln

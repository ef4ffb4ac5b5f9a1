// compile(): the table of contents of the program. Read pipeline.cpp first; every line of it is a room.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/ground/profiles/measure_profiles.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"

namespace citykiln {

struct CompileResult {
  scene::Scene scene;
  Report report;
  ground::ProfileMeasures profiles;  ///< What they keep of what they promise.
  std::vector<StageCost> costs;
};

/// From a map and heightmaps to the scene: every object's recipe, and the ledger of how it became one.
///
/// Guarantees: same inputs and spec, same scene, whatever the threads and the order of elements in the file; a tile
/// asked for by spec.only is the tile that the whole holds. Errors: an input that cannot be read; a map that holds
/// nothing to compile; heightmaps that cover nothing of the map; tiles outside of it. Cost: the stages', each linear
/// but for the read's sorting; memory that of the extract.
Result<CompileResult> compile(const CompileSpec& spec, const OnProgress& on_progress);

/// Takes one tile at one level; an error ends the firing.
using OnBakedTile = std::function<Result<Done>(const bake::BakedTile& tile, std::size_t level)>;

/// Which chunk of a scene, at which step of a ladder.
struct ChunkLevel {
  std::size_t chunk, level;
};
/// Makes something of a baked tile, beside others: it must write to a place of its own only.
using ProcessTile = std::function<void(ChunkLevel at, bake::BakedTile&& tile)>;
/// Takes what was made of it; an error ends the firing.
using CollectTile = std::function<Result<Done>(ChunkLevel at)>;

/// Bakes every chunk at every tolerance and hands each on, one at a time and in the order of tiles then levels. What
/// the tolerances drop is added to `report`. Memory: kInFlightPerThread levels a thread, and the ground of their tiles
/// and one more.
Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> ladder_m, int threads, Report& report,
                        const OnProgress& on_progress, const OnBakedTile& take);

/// The same, where much is done with a tile that need not wait for the tiles before it: `make` is called as soon as one
/// is baked, `take` in order.
Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> ladder_m, int threads, Report& report,
                        const OnProgress& on_progress, const ProcessTile& make, const CollectTile& take);

}  // namespace citykiln

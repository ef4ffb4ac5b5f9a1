// Stage 11: fires the clay of one tile at a tolerance.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/view_levels.h"
#include "compiler/contract/report.h"
#include "compiler/ground/generate.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// A pure function of header, chunk and tolerance. Ledger "bake/bridge", "bake/building", "bake/tree", "bake/barrier",
/// "bake/lamp" (mapped ones), "bake/derived lamp" (along lit streets): what the tolerance drops. Total. Cost: linear in
/// what the tile holds at that tolerance, but for the ground's n log n.
/// @param grove  Of the header, here and below. Who fires many tiles shares one; without, plants grow anew.
BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads, Report& report,
               std::shared_ptr<const PrototypeCache> prototypes = nullptr);

/// The same at every tolerance of a ladder, in its order: what levels have in common is made once. The report takes the
/// levels one after another. Memory: all levels; whoever has no need of all at once prepares and fires them one by one.
std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m,
                            int threads, Report& report, std::shared_ptr<const PrototypeCache> prototypes = nullptr);

/// What the levels of a tile have in common, and their ground; each level's own part goes when it is fired.
struct PreparedTile;
std::shared_ptr<PreparedTile> prepare(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const double> ladder_m, int threads,
                                      std::shared_ptr<const PrototypeCache> prototypes = nullptr);

/// The `level`-th tile of the ladder that was prepared, as bake() makes it. Each level once, in any order and on any
/// thread.
BakedTile bake_prepared(PreparedTile& prepared, std::size_t level, int threads, Report& report);

/// The ground's cells of a level that has not been fired yet.
std::span<const ground::GroundMesh> ground_of(const PreparedTile& prepared, std::size_t level);

/// The tile for one eye, as parts: one a tolerance, finest first, each with what is made at it. Together they are the
/// tile (commands/join_tiles.h). Each states its largest pixel error. Nothing is reported: what a level drops is too
/// small to be seen. Total. Cost: what the parts hold.
std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view, int threads,
                            std::shared_ptr<const PrototypeCache> prototypes = nullptr);

}  // namespace citykiln::bake

// Stage 11: bakes one tile of a scene at a tolerance.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/ground_cells.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/view_levels.h"
#include "compiler/contract/report.h"
#include "compiler/ground/generate.h"
#include "compiler/scene/land_cover.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Bakes a tile: a pure function of header, chunk and tolerance. Objects that the tolerance drops are counted in the
/// accounts "bake/bridge", "bake/tunnel", "bake/building", "bake/tree", "bake/barrier", "bake/lamp" (mapped ones) and
/// "bake/derived lamp" (along lit streets).
///
/// @param tolerance_m  > 0.
/// @param prototypes  Of the same header, here and below; tiles may share one. Null: plants are generated for this
/// call. Total. Cost: linear in what the tile holds at the tolerance, n log n in its ground.
BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads, Report& report,
               std::shared_ptr<const PrototypeCache> prototypes = nullptr);

/// Bakes a tile at every tolerance of a ladder, in its order; what levels have in common is made once. The report gets
/// the levels one after another. Memory: all levels at once, which prepare() and bake_prepared() avoid.
std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m,
                            int threads, Report& report, std::shared_ptr<const PrototypeCache> prototypes = nullptr);

/// The most instances that a tile should have; beyond, plants of stands become meshes (stands.h).
inline constexpr std::size_t kAnyInstances = std::numeric_limits<std::size_t>::max();

/// What the levels of a tile have in common, and the ground of each level that is not baked yet.
struct PreparedTile;
std::shared_ptr<PreparedTile> prepare(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const double> ladder_m, int threads,
                                      std::shared_ptr<const PrototypeCache> prototypes = nullptr,
                                      std::size_t most_instances = kAnyInstances);

/// Returns the same as prepare(), with all references for expected_ground_of().
std::shared_ptr<PreparedTile> prepare_for_check(const scene::Header& header, const scene::Chunk& chunk,
                                                std::span<const double> ladder_m, int threads,
                                                std::shared_ptr<const PrototypeCache> prototypes = nullptr,
                                                std::size_t most_instances = kAnyInstances);

/// The ground that a level must show. Levels may share its parts.
struct ExpectedGround {
  std::shared_ptr<const ground::GradedTerrain> graded;
  std::shared_ptr<const scene::LandCover> cover;
  CellReferences references;  ///< In the order of cells_of.
};

/// Returns the expected ground of a level that is not baked yet, of a tile from prepare_for_check().
ExpectedGround expected_ground_of(const PreparedTile& prepared, std::size_t level);

/// Bakes one level of the ladder, with the same result as bake(). Call once per level, in any order, on any thread.
BakedTile bake_prepared(PreparedTile& prepared, std::size_t level, int threads, Report& report);

/// The ground of each cell of a level that is not baked yet.
std::span<const ground::GroundMesh> ground_of(const PreparedTile& prepared, std::size_t level);

/// Bakes the tile for one viewpoint, as one part per tolerance, finest first; all parts together are the tile
/// (commands/join_tiles.h). Each part states its largest error in pixels. Objects that are dropped are too small to be
/// seen and are not counted. Each part has at most its share of the instances. Total. Cost: what the parts hold.
std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view, int threads,
                            std::shared_ptr<const PrototypeCache> prototypes = nullptr,
                            std::size_t most_instances = kAnyInstances);

}  // namespace citykiln::bake

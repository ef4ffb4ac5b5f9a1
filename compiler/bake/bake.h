// Bakes one tile of a scene, which means to generate its meshes from its recipes: at one tolerance, at several (levels
// of detail), or for a viewpoint. A chunk holds the recipes of one tile, a header the properties of the whole scene.
//
// Results own their data: a BakedTile refers to no argument. A PreparedTile refers to header and chunk, which must
// outlive it unchanged, and shares the prototypes. `threads` does not change results; nothing here can fail.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/ground/ground_cells.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/bake/view/view_levels.h"
#include "compiler/contract/findings/report.h"
#include "compiler/ground/generate.h"
#include "compiler/scene/land_cover.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

/// Bakes a tile at a tolerance: a pure function of header, chunk and tolerance. Objects smaller than the tolerance are
/// dropped in the accounts "bake/bridge", "bake/tunnel", "bake/building", "bake/barrier", "bake/wires", "bake/thing",
/// "bake/parked car", "bake/street furniture", "bake/lamp" (mapped lamps) and "bake/derived lamp" (lamps along lit
/// streets). The account "bake/tree" drops only mapped trees on roads, rails, buildings or water.
///
/// @param tolerance_m  Largest deviation, > 0.
/// @param prototypes   Shared meshes of plants, for all tiles of this header. Null: they are made for this call. The
///                     other functions with this parameter do the same.
///
/// Cost: linear in the objects that are baked, n log n in the ground's vertices.
BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads, Report& report,
               std::shared_ptr<const PrototypeCache> prototypes = nullptr);

/// Bakes all levels of a tile, one for each tolerance in `tolerances_m`, in this order, each with the result of bake()
/// at this tolerance. Data that levels share is made once. The report gets the findings level by level. All levels are
/// in memory at once; prepare() and bake_prepared() avoid this.
std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk,
                            std::span<const double> tolerances_m, int threads, Report& report,
                            std::shared_ptr<const PrototypeCache> prototypes = nullptr);

/// The value of most_instances for no limit. `most_instances` is the number of instances (plants, lamps and things)
/// above which a tile's plants become merged meshes (stands.h).
inline constexpr std::size_t kAnyInstances = std::numeric_limits<std::size_t>::max();

/// A tile whose levels can be baked one by one: the data that levels share, and the ground of each level that is not
/// baked yet. Refers to header and chunk.
struct PreparedTile;
/// Prepares a tile: makes the shared data and the ground of all levels, one per tolerance. Never null.
std::shared_ptr<PreparedTile> prepare(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const double> tolerances_m, int threads,
                                      std::shared_ptr<const PrototypeCache> prototypes = nullptr,
                                      std::size_t most_instances = kAnyInstances);

/// Prepares a tile like prepare(), and keeps the ground at full detail for expected_ground_of().
std::shared_ptr<PreparedTile> prepare_for_check(const scene::Header& header, const scene::Chunk& chunk,
                                                std::span<const double> tolerances_m, int threads,
                                                std::shared_ptr<const PrototypeCache> prototypes = nullptr,
                                                std::size_t most_instances = kAnyInstances);

/// The ground at full detail that a level approximates, for measuring errors. Levels may share its members.
struct ExpectedGround {
  std::shared_ptr<const ground::GradedTerrain> graded;
  std::shared_ptr<const scene::LandCover> cover;
  CellReferences references;  ///< Triangulations at full detail, one per cell, in the order of cells_of().
};

/// Returns the ground that a level approximates, for a tile from prepare_for_check(). The level must not be baked yet;
/// the result stays valid when it is.
ExpectedGround expected_ground_of(const PreparedTile& prepared, std::size_t level);

/// Bakes one level of a prepared tile: the result of bake() at its tolerance, except that plants become merged meshes
/// if prepare() was given a most_instances that the level exceeds. Call it once per level, in any order, on any thread,
/// also at the same time as other levels. The level's ground is freed.
/// @param level  Index of its tolerance in the tolerances of prepare().
BakedTile bake_prepared(PreparedTile& prepared, std::size_t level, int threads, Report& report);

/// Returns the ground of each cell of a level that is not baked yet, in the order of cells_of(). The span is valid
/// until the level is baked.
std::span<const ground::GroundMesh> ground_of(const PreparedTile& prepared, std::size_t level);

/// Bakes a tile for one viewpoint, as one part per tolerance, finest first. All parts together are the tile
/// (bake/tiles/join_tiles.h joins them). Each part states its largest error in pixels. Dropped objects are not counted,
/// as they are too small to be seen. Each of n parts may have most_instances / n instances. Cost: linear in the objects
/// of the parts.
/// @param view  Tolerances of all cells for the viewpoint.
std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view, int threads,
                            std::shared_ptr<const PrototypeCache> prototypes = nullptr,
                            std::size_t most_instances = kAnyInstances);

}  // namespace citykiln::bake

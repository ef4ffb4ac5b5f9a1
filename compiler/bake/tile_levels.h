// The levels of detail of a tile after their ground has been generated and before their objects are baked. Data that
// levels share is made once.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bake/ground/ground_cells.h"
#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/bake/place_generated.h"
#include "compiler/bake/place_lamps.h"
#include "compiler/bake/place_things.h"
#include "compiler/bake/view/view_levels.h"
#include "compiler/buildings/generate.h"
#include "compiler/plants/generate.h"
#include "compiler/plants/prototypes/canopy.h"
#include "compiler/props/generate.h"
#include "compiler/props/recipe.h"
#include "compiler/props/tree_pits.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// Data that does not depend on the tolerance: the graded terrain, and plants, lamps and stairs placed on it. All
/// levels with Detail::kRoadSurfaces share one, all others share a second one.
struct SharedByLevels {
  std::shared_ptr<const ground::GradedTerrain> graded;
  plants::PlacedPlants trees{};
  /// Grass, reed and corn, for levels with Detail::kGrassBlades; empty if no level has it.
  plants::PlacedPlants blades{};
  Report tree_report{};  ///< Account and diagnoses of placing plants.
  std::vector<props::TreePit> pits{};
  Lamps lamps{};
  std::vector<PlacedThing> things{};
  std::vector<PlacedPoleSpan> pole_spans{};
  std::vector<structures::Stairs> stairs{};
  std::vector<plants::Canopy> canopies{};  ///< Surfaces over closed woods: one for each level with
                                           ///< Detail::kWoodCanopies, in the order of levels.
};

/// The meshes of each building of the chunk.
using BuildingMeshes = std::vector<buildings::GeneratedBuilding>;

/// One level of a tile, or one part of a tile for a viewpoint: its ground, and its buildings if they were generated for
/// several levels together. A cell is a 128 m square of ground.
struct TileLevel {
  double tolerance_m;
  std::shared_ptr<const SharedByLevels> shared;
  std::shared_ptr<const scene::LandCover> cover = std::make_shared<scene::LandCover>();
  /// The atlas that all parts for a viewpoint share; null: the level draws its own.
  std::shared_ptr<const Markings> markings{};
  std::vector<ViewCell> seen{};             ///< The cells of this level.
  std::vector<ground::GroundMesh> cells{};  ///< One per entry of `seen`.
  CellReferences references{};  ///< Triangulations at full detail, for measuring errors: one per entry of `seen` if
                                ///< they are kept, else none.
  std::vector<ViewCell> seen_beyond{};       ///< Ground outside of the extent, under buildings (ground_beyond.h).
  std::vector<ground::GroundMesh> beyond{};  ///< One per entry of `seen_beyond`.
  Report cell_report{};
  std::optional<BuildingMeshes> buildings{};
  Report building_report{};
  std::optional<std::size_t> canopy{};         ///< Index into SharedByLevels::canopies.
  std::span<const props::Barrier> barriers{};  ///< All of the tile, also for a single cell: tufts keep clear of them.
};

/// Choice to keep the cells' reference triangulations (the ground at full detail) after the ground is generated, so
/// that files can be compared with them. They need as much memory as the finest ground.
enum class KeptReferences {
  kNone,  ///< They are dropped.
  kAll    ///< They are kept.
};

/// Returns one level per tolerance for a whole tile, with ground but without buildings. Cost: generating the ground.
std::vector<TileLevel> levels_of(const scene::Header& header, const scene::Chunk& chunk,
                                 std::span<const double> tolerances_m, int threads, KeptReferences kept);

/// Returns one level per part of a tile for a viewpoint, with shared data and land cover, but without ground.
/// @param parts  The levels of the parts: result of levels_of_parts().
std::vector<TileLevel> bare_levels_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                            const ViewLevels& view, std::span<const int> parts);

/// The index of the cell whose tolerance applies to a box of ground beyond the extent: the first cell that the box
/// touches.
std::size_t cell_beside(std::span<const ViewCell> cells, const Box2& box);

/// Generates the ground of a level that has none.
/// @param seen    The cells of the level.
/// @param beyond  Boxes of ground beyond the extent, under buildings (ground_beyond.h).
void generate_ground(TileLevel& level, std::vector<ViewCell> seen, std::span<const Box2> beyond, int threads);

/// Returns one level per part of a tile for a viewpoint, with the ground of that part's cells.
/// @param parts  Result of levels_of_parts().
std::vector<TileLevel> levels_for_view(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                                       std::span<const int> parts, int threads);

}  // namespace citykiln::bake

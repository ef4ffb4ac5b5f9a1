// The levels of a tile before they are baked. Data that levels share is made once, and the ground of all levels is
// generated together.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bake/ground/ground_cells.h"
#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/bake/place_lamps.h"
#include "compiler/bake/view_levels.h"
#include "compiler/buildings/generate.h"
#include "compiler/plants/generate.h"
#include "compiler/plants/prototypes/canopy.h"
#include "compiler/props/generate.h"
#include "compiler/props/tree_pits.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// The graded terrain, and placed objects on it. All levels with Detail::kRoadSurfaces share one, all levels without it
/// another.
struct SharedByLevels {
  std::shared_ptr<const ground::GradedTerrain> graded;
  plants::PlacedPlants trees{};
  plants::PlacedPlants blades{};  ///< For levels with Detail::kGrassBlades; empty if no level has it.
  Report tree_report{};
  std::vector<props::TreePit> pits{};
  Lamps lamps{};
  std::vector<structures::Stairs> stairs{};
  std::vector<plants::Canopy> canopies{};  ///< One for each level with Detail::kWoodCanopies, in their order.
};

/// The meshes of each building of the chunk.
using BuildingMeshes = std::vector<buildings::GeneratedBuilding>;

/// One level: its ground, and its buildings if they are generated for several levels together.
struct TileLevel {
  double tolerance_m;
  std::shared_ptr<const SharedByLevels> shared;
  std::shared_ptr<const scene::LandCover> cover = std::make_shared<scene::LandCover>();
  std::shared_ptr<const Markings> markings{};  ///< Shared by all levels of a view; null: the level draws its own.
  std::vector<ViewCell> seen{};
  std::vector<ground::GroundMesh> cells{};   ///< One per entry of `seen`.
  CellReferences references{};               ///< One per entry of `seen` if they are kept, else none.
  std::vector<ViewCell> seen_beyond{};       ///< Ground outside of the extent, under buildings (ground_beyond.h).
  std::vector<ground::GroundMesh> beyond{};  ///< One per entry of `seen_beyond`.
  Report cell_report{};
  std::optional<BuildingMeshes> buildings{};
  Report building_report{};
  std::optional<std::size_t> canopy{};  ///< Index into SharedByLevels::canopies.
};

/// Choice to keep the references of ground cells with the level, in order to measure files against them. They need as
/// much memory as the finest ground.
enum class KeptReferences { kNone, kAll };

/// Returns the levels of a whole tile, without buildings. Cost: generating the ground.
std::vector<TileLevel> levels_of(const scene::Header& header, const scene::Chunk& chunk,
                                 std::span<const double> tolerances_m, int threads, KeptReferences kept);

/// Returns a level for each part of a tile for a view, with shared data and land cover, but without ground.
/// @param parts  Result of levels_of_parts().
std::vector<TileLevel> bare_levels_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                            const ViewLevels& view, std::span<const int> parts);

/// The index of the cell whose level is used for a box of ground beyond the extent: the first cell that the box
/// touches.
std::size_t cell_beside(std::span<const ViewCell> cells, const Box2& box);

/// Generates the ground of a level that has none: cells, and boxes beyond the extent.
void generate_ground(TileLevel& level, std::vector<ViewCell> seen, std::span<const Box2> beyond, int threads);

/// Returns a level for each part of a tile for a view, with the ground of that level's cells.
/// @param parts  Result of levels_of_parts().
std::vector<TileLevel> levels_for_view(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                                       std::span<const int> parts, int threads);

}  // namespace citykiln::bake

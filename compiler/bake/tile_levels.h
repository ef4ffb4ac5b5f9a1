// The levels of a tile before they are baked: what they share is made once, and their ground together.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bake/ground_cells.h"
#include "compiler/bake/ground_meshes.h"
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

/// What all levels with Detail::kRoadSurfaces share, and what all levels without it do: the graded terrain, and what
/// stands on it.
struct SharedByLevels {
  std::shared_ptr<const ground::GradedTerrain> graded;
  plants::PlacedPlants trees{};
  plants::PlacedPlants blades{};  ///< For levels with Detail::kGrassBlades; empty where no level has it.
  Report tree_report{};
  std::vector<props::TreePit> pits{};
  Lamps lamps{};
  std::vector<structures::Stairs> stairs{};
  std::vector<plants::Canopy> canopies{};  ///< Of the levels with Detail::kWoodCanopies, in their order.
};

/// One per building of the chunk.
using BuildingMeshes = std::vector<buildings::GeneratedBuilding>;

/// One level: its ground, and its buildings where levels share what these are made of.
struct TileLevel {
  double tolerance_m;
  std::shared_ptr<const SharedByLevels> shared;
  std::shared_ptr<const scene::LandCover> cover = std::make_shared<scene::LandCover>();
  std::shared_ptr<const Markings> markings{};  ///< Of all levels of a view; null: the level draws its own.
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

/// Whether the references of ground cells are kept with the level, to measure files against them. They need as much
/// memory as the finest ground.
enum class KeptReferences { kNone, kAll };

/// Returns the levels of a whole tile, complete but for buildings. Cost: the ground's.
std::vector<TileLevel> levels_of(const scene::Header& header, const scene::Chunk& chunk,
                                 std::span<const double> ladder_m, int threads, KeptReferences kept);

/// Returns a level per part of a tile for a view: what levels share and their land cover, without ground.
/// @param parts  As levels_of_parts() returns them.
std::vector<TileLevel> bare_levels_for_view(const scene::Header& header, const scene::Chunk& chunk,
                                            const ViewLevels& view, std::span<const int> parts);

/// The index of the cell to whose level ground beyond the extent belongs: the first that a box touches.
std::size_t cell_beside(std::span<const ViewCell> cells, const Box2& box);

/// Generates the ground of a bare level: cells, and boxes beyond the extent.
void generate_ground(TileLevel& level, std::vector<ViewCell> seen, std::span<const Box2> beyond, int threads);

/// Returns a level per part of a tile for a view, with the cells of that level.
/// @param parts  As levels_of_parts() returns them.
std::vector<TileLevel> levels_for_view(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                                       std::span<const int> parts, int threads);

}  // namespace citykiln::bake

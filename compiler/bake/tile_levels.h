// The levels of a tile before they are fired: what they have in common is made once, and their ground together.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bake/ground_cells.h"
#include "compiler/bake/view_levels.h"
#include "compiler/buildings/generate.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/plants/generate.h"
#include "compiler/plants/prototypes/canopy.h"
#include "compiler/props/generate.h"
#include "compiler/props/tree_pits.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/structures/stairs.h"

namespace citykiln::bake {

/// What stands along streets. Mapped ones first.
struct Lamps {
  std::vector<props::StreetLamp> standing;
  std::size_t mapped = 0;
};

/// What the levels with or without Detail::kRoadSurfaces have in common: how the ground is carved, and what stands on
/// it.
struct SharedByLevels {
  ground::GradedTerrain graded;
  plants::PlacedPlants trees;
  plants::PlacedPlants blades;  ///< With Detail::kGrassBlades; empty where there are none.
  Report tree_report;
  std::vector<props::TreePit> pits;
  Lamps lamps;
  std::vector<structures::Stairs> stairs;
  std::map<double, plants::Canopy> canopies;  ///< Of whole tiles, by tolerances with Detail::kWoodCanopies.
};

/// Whether hedges along lines are rows of plants at a tolerance, no bands. For one eye they are at all: a hedge may be
/// near and far.
inline bool has_hedge_plants(double tolerance_m) { return has_detail(Detail::kHedgePlants, tolerance_m); }

/// One an object of the chunk.
using BuildingMeshes = std::vector<buildings::GeneratedBuilding>;

/// One level's part of the ground, and its houses where levels share what those are made of.
struct TileLevel {
  double tolerance_m;
  std::shared_ptr<const SharedByLevels> common;
  scene::LandCover cover;
  std::vector<ViewCell> seen;
  std::vector<ground::GroundMesh> cells{};
  Report cell_report{};
  std::optional<BuildingMeshes> houses{};
  Report building_report{};
};

/// Whole tiles, with all but houses.
std::vector<TileLevel> levels_of(const scene::Header& header, const scene::Chunk& chunk,
                                 std::span<const double> ladder_m, int threads);

/// For one eye: a level a part, with the cells that have its tolerance.
std::vector<TileLevel> levels_for_view(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view,
                                       std::span<const double> tolerances_m, int threads);

}  // namespace citykiln::bake

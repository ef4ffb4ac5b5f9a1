// Generates plants: from recipes to placements of prototypes in a box.
#pragma once

#include "compiler/plants/placing/placing.h"

namespace citykiln::plants {

/// The recipes of a tile and of kObstacleInfluence_m around it.
struct PlantRecipes {
  std::span<const Tree> trees;
  std::span<const Wood> woods;
  std::span<const Planting> plantings;
  std::span<const TreeRow> rows;
  std::span<const PowerLineCorridor> corridors;
};

/// Returns the plants in the box, without blades. Distances between trees of woods are measured on the terrain; all
/// plants stand on the graded terrain.
///
/// Guarantees: no trunk of a wood or planting is within kTrunkClearance_m of a road, building or water; trees of woods
/// are blue noise (blue_noise.h), clear of mapped trees, rows and corridors; a plant depends on nothing beyond
/// kInfluenceRadius_m. A single tree up to 8 m inside a carriageway or railway, or up to 2 m inside a building or
/// water, moves to half a metre beside it (kTreeMoved); one deeper inside is dropped (kTreeOnRoad). Trees of rows are
/// left out there. Ledger "bake/tree" for single trees. O(n log n).
PlacedPlants generate(const PlantRecipes& recipes, const PlacingContext& context, Report& report);

/// Blades are grass, reed and corn, a plant for each tuft. Only tolerances with Detail::kGrassBlades show them; coarser
/// levels have them in the ground's texture, without a stated error. Where recipes ask for more than this limit, a
/// share of all is drawn.
inline constexpr double kMostBladesPerKm2 = 200'000;

/// Returns the blades in the box. O(plants asked for).
PlacedPlants generate_blades(std::span<const Planting> plantings, const PlacingContext& context);

}  // namespace citykiln::plants

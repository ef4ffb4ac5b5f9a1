// Generates the plants in a box from recipes, plain data about trees, woods and rows: places of prototypes. A prototype
// is one of the few distinct plants of a species; plants are scaled copies of its mesh.
#pragma once

#include "compiler/plants/placing/placing.h"

namespace citykiln::plants {

/// The recipes in a tile and up to kObstacleInfluence_m around it.
struct PlantRecipes {
  std::span<const Tree> trees;
  std::span<const Wood> woods;
  std::span<const Planting> plantings;
  std::span<const TreeRow> rows;
  std::span<const PowerLineCorridor> corridors;
};

/// The plants of a box.
struct GeneratedPlants {
  PlacedPlants placed;
  /// Where single trees and trees of rows stand, in the box and at least up to kTrunksAbout_m around it.
  std::vector<Vec2> trunks;
};

/// Returns the plants in the box of `context`, without blades. Distances between trees of woods are measured on the
/// terrain; all plants stand on the graded terrain.
///
/// Guarantees: no trunk of a wood or planting is within kTrunkClearance_m of a road, building or water other than the
/// sea; for plantings up to 2 m tall this distance is 0.25 m. Trees of woods are blue noise (blue_noise.h) and keep
/// clear of mapped trees, rows and corridors. A plant does not depend on data beyond kInfluenceRadius_m, except that
/// trees of a row depend on its whole axis. A single tree up to 8 m inside a carriageway or railway, or up to 2 m
/// inside a building or water, moves to half a metre beside it (kTreeMoved); one deeper inside is dropped
/// (kTreeOnRoad). Trees of rows are left out there. Single trees are counted in the account "bake/tree" of the report's
/// ledger (contract/findings/report.h). O(n log n).
GeneratedPlants generate(const PlantRecipes& recipes, const PlacingContext& context, Report& report);

/// The largest density of blades. Blades are grass, reed and corn, with one plant per tuft. Only tolerances with
/// Detail::kGrassBlades show them; coarser levels show them in the ground's texture, without a stated error. If recipes
/// have more than this limit, a share of all is drawn.
inline constexpr double kMostBladesPerKm2 = 200'000;

/// Returns the blades in the box of `context`. O(blades in the recipes).
PlacedPlants generate_blades(std::span<const Planting> plantings, const PlacingContext& context);

}  // namespace citykiln::plants

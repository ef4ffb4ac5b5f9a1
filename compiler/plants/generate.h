// From recipes of plants to where each one stands.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/plants/recipe.h"

namespace citykiln::plants {

/// A trunk's least distance to roads, paths, rails, water and buildings, and to what else lies on top of land (priority
/// 50 and more), in woods and plantings.
inline constexpr double kTrunkClearance_m = 1.25;

/// Where plants stand, by shape; scale is the height in metres.
using PlacedPlants = std::map<Prototype, std::vector<Placement>>;

/// How far outside the box surfaces must be known for a wood's trees to be decided (a named reach, DESIGN section 8.4).
inline constexpr double kInfluenceRadius_m = 48;

/// The tallest that a tree can be drawn, metres: whatever the map says.
inline constexpr double kTallestPlant_m = 40;

/// What stands in a tile and kObstacleInfluence_m around it.
struct PlantRecipes {
  std::span<const Tree> trees;
  std::span<const Wood> woods;
  std::span<const Planting> plantings;
  std::span<const TreeRow> rows;
  std::span<const PowerLineCorridor> corridors;
};

/// Where it stands.
struct PlacingContext {
  const ground::LandCoverIndex& surfaces;  ///< Covers the box widened by kInfluenceRadius_m.
  const ground::GradedTerrain& ground;     ///< Carved in the box; its terrain covers as much as the surfaces.
  Box2 box;                                ///< What is in it is placed; half-open.
  std::uint64_t seed = 0;
  double latitude_deg = 0;  ///< Shifts belts of altitude.
};

/// The plants that stand in the box, but for blades. Trees of woods keep apart on the terrain, and stand on the carved
/// ground.
///
/// Guarantees: no trunk of a wood or planting within kTrunkClearance_m of a road, building or water; trees of all woods
/// at even distances (blue_noise.h), clear of mapped trees, rows and lanes; a plant depends on nothing beyond
/// kInfluenceRadius_m. Single trees up to 2 m inside of a carriageway's edge stand half a metre beside it, diagnosed
/// kTreeMoved; those deeper in, on a building or water are dropped, diagnosed kTreeOnRoad; those of rows are left out.
/// Ledger "bake/tree" for single trees. O(n log n).
PlacedPlants generate(const PlantRecipes& recipes, const PlacingContext& land, Report& report);

/// Grass, reed and corn: at tolerances with Detail::kGrassBlades, one plant for a tuft. Beyond, the ground's texture
/// stands for them, and no error is stated.

/// At most so many of them stand on a square kilometre; where recipes ask for more, some of all are left out.
inline constexpr double kMostBladesPerKm2 = 200'000;

/// Those that stand in the box. O(plants asked for).
PlacedPlants generate_blades(std::span<const Planting> plantings, const PlacingContext& land);

/// A hedge as mapped.
struct HedgeLine {
  const Polyline& axis;
  double height_m = 0;
  OsmId feature;
};

/// The pieces in the box of a row along the axis, each as long as high, on whatever is there. O(length).
void add_hedge(const HedgeLine& hedge, const PlacingContext& land, PlacedPlants& placed);

}  // namespace citykiln::plants

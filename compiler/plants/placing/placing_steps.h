// The steps that place the plants of a tile, one for each kind of recipe.
#pragma once

#include <span>
#include <vector>

#include "compiler/plants/placing/placing.h"
#include "compiler/plants/placing/tree_clearance.h"

namespace citykiln::plants {

/// Places single trees. Returns their clearances and those of the trees near the box. Ledger "bake/tree".
std::vector<TreeClearance> place_trees(PlacedPlants& placed, std::span<const Tree> trees, const PlacingContext& context,
                                       Report& report);

/// The trees of rows are known up to this distance from the box, at least kMostClearance_m, which woods keep from them.
/// Tiles agree on them, as they know single trees, which replace those of rows, up to twice as far.
inline constexpr double kTrunksAbout_m = 8;
static_assert(kTrunksAbout_m >= kMostClearance_m && kTrunksAbout_m + kMostClearance_m <= kObstacleInfluence_m);

/// Places the trees of rows, except within the clearance of a tree of `trees`. Returns `trees` and those of rows.
std::vector<TreeClearance> place_rows(PlacedPlants& placed, std::span<const TreeRow> rows,
                                      std::vector<TreeClearance> trees, const PlacingContext& context);

/// Places the trees of woods.
/// @param trees  Mapped trees and trees of rows, which trees of woods keep clear of.
void place_woods(PlacedPlants& placed, std::span<const Wood> woods, std::span<const TreeClearance> trees,
                 std::span<const PowerLineCorridor> corridors, const PlacingContext& context);

/// Places all plantings (plants in rows) except blades: grass, reed and corn.
/// @param trees  They leave gaps in the rows.
void place_plantings(PlacedPlants& placed, std::span<const Planting> plantings, std::span<const TreeClearance> trees,
                     const PlacingContext& context);

/// Places plantings of grass, reed and corn; only a share of the blades if there would be more than `most_per_km2`.
void place_blades(PlacedPlants& placed, std::span<const Planting> plantings, double most_per_km2,
                  const PlacingContext& context);

/// A mapped hedge.
struct HedgeLine {
  const Polyline& axis;
  double height_m = 0;
  OsmId feature;
};

/// Adds the pieces of a hedge along its axis, of equal lengths, at most as long as the hedge is high. A closed axis has
/// no gap. Ignores land cover. O(length).
void place_hedge(PlacedPlants& placed, const HedgeLine& hedge, const PlacingContext& context);

}  // namespace citykiln::plants

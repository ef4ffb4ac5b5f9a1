// Plans plants: makes recipes, plain data from which plants are placed later, from tags and land cover.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/plants/recipe.h"
#include "compiler/plants/species_table.h"
#include "compiler/roads/recipe.h"

namespace citykiln::plants {

/// All plant recipes of a map.
struct Plants {
  std::vector<Tree> trees;                   ///< Sorted by id.
  std::vector<Wood> woods;                   ///< Sorted by surface.
  std::vector<Planting> plantings;           ///< Sorted by surface.
  std::vector<TreeRow> rows;                 ///< Sorted by id.
  std::vector<PowerLineCorridor> corridors;  ///< In the order of features.power_lines.
};

/// Returns the mapped trees, tree rows and power-line corridors, rows beside streets with tree_lined, and a wood
/// (wood_defaults.inc) or a planting (planting_defaults.inc, crops) for each polygon whose class or tags imply one.
///
/// @param features  Areas and tracks sorted by id.
/// @param assumed   Trees on land in towns that nothing covers are there with Assumption::kYards alone.
/// @param table     The species, and the spawners to which tags refer.
///
/// Accepts any features. Ledgers "plants/tree", "plants/row". O(n log n).
Plants plan(const map::FeatureView& features, std::span<const ground::LandCoverPolygon> surfaces,
            std::span<const roads::Road> roads, const map::Heightfield& terrain, Report& report,
            Assumptions assumed = kAllAssumptions, const SpeciesTable& table = shipped_table());

}  // namespace citykiln::plants

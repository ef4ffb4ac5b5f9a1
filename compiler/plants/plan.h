// Stage 7: what plants the map tells of, and where they grow unasked.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/plants/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::plants {

struct Plants {
  std::vector<Tree> trees;                   ///< Sorted by id.
  std::vector<Wood> woods;                   ///< Sorted by surface.
  std::vector<Planting> plantings;           ///< Sorted by surface.
  std::vector<TreeRow> rows;                 ///< Sorted by id.
  std::vector<PowerLineCorridor> corridors;  ///< Sorted by id.
};

/// Single trees and rows as tagged, and along streets that tell they are lined with trees; a wood (woods_of.inc) or
/// rows (plantings_of.inc, crops) for every surface whose class or tags say so. Ledger "plants/tree", "plants/row".
/// Total. O(n log n).
Plants plan(const map::Features& features, std::span<const ground::LandCoverPolygon> surfaces,
            std::span<const roads::Road> roads, const map::Heightfield& terrain, Report& report);

}  // namespace citykiln::plants

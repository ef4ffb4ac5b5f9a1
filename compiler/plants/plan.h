// Stage 7: trees and woods.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"
#include "compiler/plants/recipe.h"

namespace citykiln::plants {

struct Plants {
  std::vector<Tree> trees;  ///< Sorted by id.
  std::vector<Wood> woods;  ///< Sorted by surface.
};

/// Single trees as tagged; a wood for every surface whose class says so (woods_of.inc). Ledger "plants/tree". Total.
Plants plan(const map::Features& features, std::span<const ground::Surface> surfaces, Report& report);

}  // namespace citykiln::plants

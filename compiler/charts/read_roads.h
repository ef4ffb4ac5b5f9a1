// A map's roads, as charts measure them.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/roads/recipe.h"

namespace citykiln::charts {

/// All roads of the ground, sorted by id, in metres about the map's middle. What is mended is not told. Errors: a map
/// that cannot be read.
Result<std::vector<roads::Road>> read_roads(const std::string& path, int threads);

}  // namespace citykiln::charts

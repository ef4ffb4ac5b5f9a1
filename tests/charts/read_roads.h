// Reads the roads of a map for charts.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/roads/recipe.h"

namespace citykiln::charts {

/// Returns all ground roads of a map, sorted by id, in metres about the middle of the map. Diagnoses are ignored.
/// Error: a map that cannot be read.
Result<std::vector<roads::Road>> read_roads(const std::string& path, int threads);

}  // namespace citykiln::charts

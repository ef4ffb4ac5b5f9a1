// The elements of an extract that have become features.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns the elements of all features. Sorted. O(n log n).
std::vector<OsmId> built_elements(const Features& features);

/// Returns the elements of all features, and those that are dropped already. Sorted. O(n log n).
std::vector<OsmId> read_elements(const Features& features, const Report& report);

}  // namespace citykiln::map

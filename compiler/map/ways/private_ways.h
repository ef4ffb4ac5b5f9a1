// Finds the ways that lie inside of lots.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"

namespace citykiln::source {
struct OsmData;
}

namespace citykiln::map {

/// Returns the ids of driveways, aisles of car parks and drive-throughs (service=*), sorted. O(n log n).
std::vector<OsmId> private_ways(const source::OsmData& osm);

}  // namespace citykiln::map

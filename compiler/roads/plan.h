// Plans roads: which tracks of the map become roads on the ground.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the track as a road, at its full width.
Road road_of(const map::Track& track);

/// Returns all tracks on the ground, sorted by id. Ledger "roads/track": tracks on bridges and in tunnels count as
/// merged, since they become structures. Total. O(n).
std::vector<Road> plan(const map::Features& features, Report& report);

/// Returns the ids of the ways that lead through buildings by their tags, sorted. O(n).
std::vector<OsmId> ways_through_buildings(const map::Features& features);

}  // namespace citykiln::roads

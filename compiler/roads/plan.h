// Stage 3: which ways become roads on the ground.
#pragma once

#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The track as a road of its network: not narrowed.
Road road_of(const map::Track& track);

/// All tracks of the ground, sorted by id. Ledger "roads/track": what leaves the ground counts as merged (into
/// structures/). Total.
std::vector<Road> plan(const map::Features& features, Report& report);

}  // namespace citykiln::roads

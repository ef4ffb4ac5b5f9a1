// Stage 4b: how high water lies. Standing water is level, running water falls along its axis.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

struct Waters {
  std::vector<LandCoverPolygon> surfaces;  ///< Those given; standing water with its level.
  std::vector<roads::Strip> streams;       ///< Those given, sorted by id, with their profiles and reaches.
};

/// Finds the heights of all water of a map, once.
///
/// @param covered  Culverts and aqueducts, through which water goes on; downstream.
/// Method: standing_water.h, river_network.h, river_uphill.h, river_heights.h, river_profile.h, river_areas.h.
/// Guarantees: every standing water is level, those that share a border together (unless kDam_m parts them); the sea
/// lies at 0; no profile rises along its axis, and streams have one height where they have a vertex in common, no lower
/// than what flows on from there. Streams that were mapped uphill are turned, axis and all. River areas keep no level:
/// they have the height of the streams that reach them (water_height.h); those that none reaches are level, like lakes.
/// Heights depend on the land within two heightfield steps of water, and on what water is connected.
/// Without heights (a field that is 0 everywhere) all is returned as it came. Total. What gives way is diagnosed:
/// kSeaLevelOffShore, kShoreSpike, kRiverAreaWithoutAxis, kWaterwayReversed, kWaterwayCycle, kLakeLevelMoved,
/// kRiverOffTerrain. Cost: 0.1 s for Andorra.
Waters plan_water_heights(std::vector<LandCoverPolygon> surfaces, std::vector<roads::Strip> streams,
                          std::span<const Polyline> covered, const map::Heightfield& heights, Report& report);

}  // namespace citykiln::ground

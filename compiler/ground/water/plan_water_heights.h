// Plans the heights of water: standing water is level, running water descends along its axis.
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
  std::vector<roads::Strip> streams;       ///< Those given, sorted by id, with profiles and influence radii.
};

/// Decides the heights of all water of a map.
///
/// @param covered  Axes of culverts and aqueducts, downstream: they connect rivers.
/// Method: standing_water.h, river_network.h, river_uphill.h, river_heights.h, river_depth.h, river_profile.h,
/// river_areas.h.
/// Guarantees: every standing water is level, polygons with a common border together (unless kDam_m parts them); the
/// sea lies at 0; no profile rises along its axis; streams have one height at a common vertex, no lower than what flows
/// on from there. Streams mapped uphill are reversed, with their axis. River areas get no level: their heights come
/// from the streams within reach (water_height.h); areas without a stream are level, like lakes. A stream that would
/// lie farther from the terrain than max_depth_m() over more than kSustained grid steps has no profile and lies on the
/// terrain (kRiverOffTerrain): its terrain, its course or the lake that it meets is wrong there. Heights depend on the
/// terrain within two grid steps of water, and on the water connected to it. Without terrain (0 everywhere) all is
/// returned as given. Total. Reports kSeaLevelOffShore, kShoreSpike, kRiverAreaWithoutAxis, kWaterwayReversed,
/// kWaterwayCycle, kLakeLevelMoved, kRiverOffTerrain. 0.1 s for Andorra.
Waters plan_water_heights(std::vector<LandCoverPolygon> surfaces, std::vector<roads::Strip> streams,
                          std::span<const Polyline> covered, const map::Heightfield& heights, Report& report);

}  // namespace citykiln::ground

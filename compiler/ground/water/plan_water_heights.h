// Plans the heights of water: levels of standing water, and descending profiles of running water.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/roads/recipe.h"

namespace citykiln::ground {

/// All water with heights.
struct Waters {
  std::vector<LandCoverPolygon> surfaces;  ///< The given polygons, in their order; standing water has its level.
  std::vector<roads::Strip> streams;       ///< The given streams, sorted by id, with profiles and influence radii.
};

/// Decides the heights of all water of a map.
///
/// @param covered  Axes of culverts and aqueducts, downstream: they connect rivers.
/// Method: standing_water.h, river_network.h, uphill_lines.h, river_heights.h, fit_rivers.h, river_depth.h,
/// river_profile.h, river_areas.h.
/// Guarantees:
/// - Standing water is level. Polygons with a common border have one level, unless their shores differ by more than
///   kDam_m. The sea is at 0.
/// - No profile rises along its axis. Streams have one height at a common vertex, no lower than any stream below it.
/// - Streams mapped uphill are reversed, axis included.
/// - Areas of rivers have no level: their heights follow from streams within the radius of influence (water_height.h).
///   Areas without a stream are level, like lakes.
/// - A stream that no fit brings within max_depth_m() of the terrain, but for stretches of up to kSustained grid steps,
///   gets no profile and lies on the terrain: its terrain, its course or the lake that it meets is wrong. It does not
///   move the streams that it meets.
/// - Distances from the terrain are those from the range between the land on the line and the lowest land across it
///   within the line's lateral error (river_network.h).
/// - Heights depend on the terrain within two grid steps of water, and on the water connected to it. Without terrain (0
///   everywhere) the inputs are returned unchanged.
///
/// Reports kSeaLevelOffShore, kShoreSpike, kRiverAreaWithoutAxis, kWaterwayReversed, kWaterwayCycle, kLakeLevelMoved;
/// kWaterwayRises, kWaterwayOffLake or kWaterwayOffNeighbours for each stream without a profile; and kRiverOffTerrain
/// for each with one that is over 10 m off the terrain over more than one grid step. Cannot fail.
Waters plan_water_heights(std::vector<LandCoverPolygon> surfaces, std::vector<roads::Strip> streams,
                          std::span<const Polyline> covered, const map::Heightfield& heights, Report& report);

}  // namespace citykiln::ground

// Limits the width of streets where buildings stand closer than their class suggests.
//
//        ___________            1. each building beside a road limits its edge (building_obstacles)
//       |           |           2. the limit opens and closes by kTaper and continues across the joints of roads
//   ____\___________/____       3. at a junction's cuts the carriageway keeps its full width, as its outline does
//    - - - - - - - - - -        4. the limit at every quarter metre becomes a few points (fit_width_limits)
//
// narrowed_section.h applies the limits to the lanes.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the roads with width limits, on streets and paths only.
///
/// @param junctions  Of these roads at their full width.
/// @param footprints  In any order. Open roofs, buildings with kHeadroom_m of clearance, outlines that parts replace,
/// and buildings that the axis runs into (near that point) do not limit a road.
/// @param through_buildings  Sorted ids of the ways that lead through buildings by their tags: never kBuildingOnRoad.
///
/// Guarantees: edges stay out of footprints, apart from snapping, wherever the minimum width (narrowed_section.h) and
/// junction cuts allow; no edge turns by more than kTaper, nor steps by more than kUnit_m where two roads join; a road
/// without a building in its strip stays unchanged; a limit depends on nothing farther along the roads than 1 / kTaper
/// times half the road's width and a block of 64 m, nor farther across than max_offset_m(); the order of roads and
/// footprints does not matter. Diagnosed, once a road: kRoadNarrowed, kBuildingOnRoad. Total. O(n log n).
std::vector<Road> limit_widths(std::vector<Road> roads, std::span<const Junction> junctions,
                               std::span<const map::Footprint> footprints, std::span<const OsmId> through_buildings,
                               Report& report);

}  // namespace citykiln::roads

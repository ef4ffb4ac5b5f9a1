// Limits the width of streets beside buildings that stand closer than the street's class suggests.
//
//        ___________            1. each building beside a road limits its edge (building_obstacles)
//       |           |           2. the limit widens and narrows by kTaper and continues across the joints of roads
//   ____\___________/____       3. at a junction's cuts the carriageway keeps its full width, as its outline does
//    - - - - - - - - - -        4. the limit at every quarter metre becomes a few points (fit_width_limits)
//
// narrowed_section.h applies the limits to the lanes.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the roads with width limits. Only streets and paths get limits.
///
/// @param junctions          Junctions of these roads, planned at full width.
/// @param footprints         In any order. Open roofs, buildings with kHeadroom_m of clearance, and outlines that parts
///                           replace do not limit a road. A building into which the axis runs does not limit the road
///                           near that place.
/// @param through_buildings  Sorted ids of the ways tagged to lead through buildings. kBuildingOnRoad is never
///                           diagnosed for these.
///
/// Guarantees: edges stay out of footprints, apart from snapping, unless the minimum width (narrowed_section.h) or a
/// junction's cut prevents it; no edge turns by more than kTaper, or jumps by more than kUnit_m at a joint of two
/// roads; a road without a building in its strip stays unchanged if no limit of a joined road reaches it. A limit
/// depends on data along the roads up to 64 m plus half the road's width / kTaper, and across them up to
/// max_offset_m(). The order of roads and footprints does not matter. Diagnosed, once a road:
/// kRoadNarrowed, kBuildingOnRoad. O(n log n).
std::vector<Road> limit_widths(std::vector<Road> roads, std::span<const Junction> junctions,
                               std::span<const map::Footprint> footprints, std::span<const OsmId> through_buildings,
                               Report& report);

}  // namespace citykiln::roads

// Streets that are narrower than their class says, because buildings stand there.
//
//        ___________            1. each building beside a road says how far out its edge may go
//        (find_building_obstacles)
//       |           |           2. the limit opens and closes by kTaper; it goes on from road to road where they join
//   ____\___________/____       3. at a junction's cuts the carriageway is whole, as the junction's outline is
//    - - - - - - - - - -        4. what is said of every quarter metre becomes a few pinches (pinches)
//
// squeeze.h says what of the road gives way.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The roads with what buildings leave of them: streets and paths; others stay as they are.
///
/// @param junctions   Of these roads; cut for roads at their whole width.
/// @param footprints  In any order. Roofs, what hangs above kHeadroom_m and outlines that parts replace do not stand in
///                    the way, nor what the axis itself runs into, so close to there.
///
/// Guarantees: edges stay out of footprints, but for the plane's snapping, wherever the least width (squeeze.h) and
/// whole junctions allow it; no edge turns by more than kTaper a metre, nor steps by more than kUnit_m where two roads
/// join; a road with no building in its strip stays as it is; what is decided at a place depends on nothing farther
/// along the roads than 1 / kTaper times half the road's breadth and a block of 64 m, nor farther across than the
/// breadth; the order of roads and footprints does not matter. Diagnosed, one a road: kRoadNarrowed, kBuildingOnRoad.
/// Total. O(n log n).
std::vector<Road> limit_widths(std::vector<Road> roads, std::span<const Junction> junctions,
                               std::span<const map::Footprint> footprints, Report& report);

}  // namespace citykiln::roads

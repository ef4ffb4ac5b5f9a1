// How wide the moving lanes of a road are.
#pragma once

#include "compiler/map/lanes/lane_flows.h"
#include "compiler/map/lanes/lane_roadside.h"

namespace citykiln::map {

/// width=*, else est_width=*, in metres: snapped, at least 2^-10. Diagnosed where it cannot be read.
std::optional<double> tagged_width_m(const LaneTags& tags);

/// Fills in every width that width:lanes left open. What width=* leaves beside the roadsides is shared evenly, the
/// lanes in the middle and then the forward ones taking the odd quanta; else each lane is as wide as the class says.
/// Two lanes that nobody counted become one where two cars would not pass each other. Diagnoses a width=* too narrow
/// for its lanes.
void share_widths(const LaneTags& tags, const LaneClass& lane_class,
                  const PerFlow<std::vector<RoadsideLane>>& roadsides, MovingLanes& moving);

}  // namespace citykiln::map

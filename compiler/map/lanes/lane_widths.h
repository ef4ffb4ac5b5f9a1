// The widths of the moving lanes of a road.
#pragma once

#include "compiler/map/lanes/lane_flows.h"
#include "compiler/map/lanes/lane_roadside.h"

namespace citykiln::map {

/// Returns width=*, else est_width=*, in metres: snapped, at least 2^-10. Diagnosed where unreadable.
std::optional<double> tagged_width_m(const LaneTags& tags);

/// Returns tagged_width_m() unless it cannot be that of the lanes that tags count: where each had more than
/// kWidestLane_m, beside what is parked, or could be where no tag says anything about the roadside. Some imports state
/// the width of the whole street, from house to house. Diagnosed: kBadTagValue.
std::optional<double> credible_width_m(const LaneTags& tags, const PerFlow<std::vector<RoadsideLane>>& roadsides,
                                       const MovingLanes& moving);

/// Sets every width that width:lanes left open. What width=*, if it is credible, leaves beside the roadsides is divided
/// evenly, odd quanta going to the lanes in the middle and then to the forward ones; without it each lane has the
/// class's width. Two lanes that no tag counted become one where two cars could not pass. Diagnosed: a width=* too
/// narrow for its lanes.
/// @param tagged_m  credible_width_m().
void share_widths(const LaneTags& tags, const LaneClass& lane_class, std::optional<double> tagged_m,
                  const PerFlow<std::vector<RoadsideLane>>& roadsides, MovingLanes& moving);

}  // namespace citykiln::map

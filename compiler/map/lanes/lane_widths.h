// The widths of the moving lanes of a road.
#pragma once

#include "compiler/map/lanes/lane_flows.h"
#include "compiler/map/lanes/lane_roadside.h"

namespace citykiln::map {

/// Returns width=*, else est_width=*, in metres: snapped, at least 2^-10. Unreadable values are diagnosed.
std::optional<double> tagged_width_m(const LaneTags& tags);

/// Returns tagged_width_m() unless it is too large for the tagged number of lanes: each would be wider than
/// kWidestLane_m, even with a row of parked cars on every side without tags of the roadside. Some imports state the
/// width of the whole street, from house to house. Diagnosed: kBadTagValue.
std::optional<double> credible_width_m(const LaneTags& tags, const PerFlow<std::vector<RoadsideLane>>& roadsides,
                                       const MovingLanes& moving);

/// Sets the width of all lanes that width:lanes does not state. A credible width=*, less the roadsides, is divided
/// evenly; odd quanta go to the lanes in the middle, then to the forward lanes. Without it each lane has the class's
/// width. Two lanes that no tag counts become one if two cars could not pass. Diagnosed: a width=* that is too small
/// for its lanes.
/// @param tagged_m  credible_width_m().
void share_widths(const LaneTags& tags, const LaneClass& lane_class, std::optional<double> tagged_m,
                  const PerFlow<std::vector<RoadsideLane>>& roadsides, MovingLanes& moving);

}  // namespace citykiln::map

// What lies beside the moving lanes of a road: cycle lanes, parked cars, shoulders, verges, cycle tracks, pavements.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_class.h"
#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// A lane beside the road. inside_m is how much of it width=* counts.
struct RoadsideLane {
  Lane lane;
  double inside_m = 0;
};

/// The roadside of a flow, from its outer lane outwards: buffer, cycle lane, parking, shoulder; then, raised, verge,
/// buffer, cycle track and pavement. At most six. Of a one-way road the other flow too has a roadside.
///
/// @param has_cycle_lane  The flow's own lanes hold one already.
std::vector<RoadsideLane> roadside_of(const LaneTags& tags, const LaneClass& lane_class, Flow flow,
                                      bool has_cycle_lane);

}  // namespace citykiln::map

// The roadsides of a road: its lanes beside the moving traffic, such as cycle lanes, parked cars and pavements.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_class.h"
#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// A lane of a roadside. inside_m is the part of its width that width=* includes.
struct RoadsideLane {
  Lane lane;
  double inside_m = 0;
};

/// Returns the roadside of a flow, from its outer lane outwards: buffer, cycle lane, parking, shoulder; then, behind
/// the kerb, verge, buffer, cycle track and pavement. At most six lanes. One-way roads have a roadside on both sides.
///
/// @param has_cycle_lane  True if the flow's moving lanes include a cycle lane.
std::vector<RoadsideLane> roadside_of(const LaneTags& tags, const LaneClass& lane_class, Flow flow,
                                      bool has_cycle_lane);

}  // namespace citykiln::map

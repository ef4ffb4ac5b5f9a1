// Reads the roadsides of a road from its tags. A flow is the traffic in one direction of the way: forward or backward.
// The roadside of a flow is on its side of the road: the lanes beside the moving traffic, such as cycle lanes, parked
// cars and pavements.
#pragma once

#include <vector>

#include "compiler/map/lanes/lane_class.h"
#include "compiler/map/lanes/lane_tags.h"

namespace citykiln::map {

/// A lane of a roadside.
struct RoadsideLane {
  Lane lane;
  double inside_m = 0;  ///< The part of the lane's width that the tag width=* includes; 0 for lanes outside the kerb.
};

/// Returns the lanes on the side of one flow, from the moving traffic outwards: buffer, cycle lane, parking and
/// shoulder on the carriageway; then verge, buffer, cycle track and pavement behind the kerb. At most six lanes.
///
/// @param flow            The side: Flow::kForward is the side on which forward traffic drives. One-way roads have both
///                        sides, too.
/// @param has_cycle_lane  True if bicycle:lanes lists a cycle lane among the moving lanes of the flow: cycleway=lane
///                        then adds no second one.
std::vector<RoadsideLane> roadside_of(const LaneTags& tags, const LaneClass& lane_class, Flow flow,
                                      bool has_cycle_lane);

/// True if tags say whether there is a pavement on the side of a flow: also none, or one mapped as a way of its own.
bool says_pavement(const LaneTags& tags, Flow flow);
/// True if tags state the width of the pavement on the side of a flow, or that there is none, not even as a way of its
/// own.
bool fixes_pavement(const LaneTags& tags, Flow flow);
/// True if tags say whether there is a verge on the side of a flow.
bool says_verge(const LaneTags& tags, Flow flow);
/// True if tags say whether cars park on the side of a flow.
bool says_parking(const LaneTags& tags, Flow flow);

}  // namespace citykiln::map

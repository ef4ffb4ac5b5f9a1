// The position of the OSM way within the carriageway.
#pragma once

#include "compiler/map/lanes/lane_flows.h"
#include "compiler/map/lanes/lane_roadside.h"

namespace citykiln::map {

/// All lanes of a road with their widths.
struct Carriageway {
  MovingLanes moving;
  PerFlow<std::vector<RoadsideLane>> roadsides;
};

/// Returns the distance of the way from the carriageway's edge on the backward flow's side. It follows from
/// placement=*; else the way lies in the middle of the width that width=* states (moving lanes, cycle lanes and cars
/// parked on the carriageway, without bays and shoulders). placement=transition is ignored. Diagnosed: kBadTagValue for
/// a lane that does not exist.
double axis_from_backward_edge_m(const LaneTags& tags, const Carriageway& road);

}  // namespace citykiln::map

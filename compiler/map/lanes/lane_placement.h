// Where in the carriageway the OSM way runs.
#pragma once

#include "compiler/map/lanes/lane_flows.h"
#include "compiler/map/lanes/lane_roadside.h"

namespace citykiln::map {

/// All lanes of a road, their widths known.
struct Carriageway {
  MovingLanes moving;
  PerFlow<std::vector<RoadsideLane>> roadsides;
};

/// From the carriageway's edge on the backward flow's side: as placement=* says; else half-way across what width=*
/// counts, the moving lanes with the cycle lanes and parked cars on the carriageway, without bays and shoulders.
/// placement=transition says nothing; a lane that is not there is diagnosed kBadTagValue.
double axis_from_backward_edge_m(const LaneTags& tags, const Carriageway& road);

}  // namespace citykiln::map

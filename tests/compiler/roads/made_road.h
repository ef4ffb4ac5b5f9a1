// Roads for tests.
#pragma once

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// A road of one lane, with raised lanes of these widths beside it. The axis is in the lane's middle.
inline Road made_road(std::int64_t id, Polyline axis, double width_m,
                      map::LandCoverClass surface = map::LandCoverClass::kResidentialRoad, double raised_left_m = 0,
                      double raised_right_m = 0) {
  using map::Lane;
  Road road;
  road.id = {{OsmType::kWay, id}, 0};
  road.axis = std::move(axis), road.surface = surface;
  const auto raised = [](double width) {
    return Lane{map::LaneKind::kSidewalk, map::LaneDirection::kBoth, width, 0, true};
  };
  if (raised_left_m > 0) road.section.lanes.push_back(raised(raised_left_m));
  road.section.lanes.push_back({map::LaneKind::kDriving, map::LaneDirection::kBoth, width_m});
  if (raised_right_m > 0) road.section.lanes.push_back(raised(raised_right_m));
  road.section.axis_offset_m = width_m / 2;
  return road;
}

}  // namespace citykiln::roads

#include "compiler/map/lanes/lanes.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/map/lanes/lane_placement.h"
#include "compiler/map/lanes/lane_roadside.h"
#include "compiler/map/lanes/lane_widths.h"

namespace citykiln::map {
namespace {

CrossSection lone_lane(const LaneTags& tags, const LaneClass& lane_class) {
  const LaneDirection way =
      lane_class.is_both_ways || !tags.is_one_way() ? LaneDirection::kBoth : way_of(tags.only_flow());
  const double width_m = tagged_width_m(tags).value_or(snapped(lane_class.width_m));
  return {{{.kind = lane_class.kind, .way = way, .width_m = width_m}}, width_m / 2};
}

// The lanes from the backward roadside to the forward one: left to right with traffic on the right.
std::vector<Lane> in_row(const Carriageway& road) {
  std::vector<Lane> lanes;
  const auto add_flow = [&](Flow flow) {
    lanes.insert(lanes.end(), road.moving.flows[flow].begin(), road.moving.flows[flow].end());
    for (const RoadsideLane& beside : road.roadsides[flow]) lanes.push_back(beside.lane);
  };
  add_flow(Flow::kBackward);
  std::reverse(lanes.begin(), lanes.end());
  lanes.insert(lanes.end(), road.moving.middle.begin(), road.moving.middle.end());
  add_flow(Flow::kForward);
  return lanes;
}

bool has_placement(const LaneTags& tags) {
  return !tags("placement").empty() || !tags("placement:forward").empty() || !tags("placement:backward").empty();
}

bool has_listed_widths(const LaneTags& tags) {
  return !tags("width:lanes").empty() || !tags("width:lanes:forward").empty() || !tags("width:lanes:backward").empty();
}

TaggedSection road_section(const LaneTags& tags, const LaneClass& lane_class) {
  diagnose_widths_beside(tags);
  Carriageway road;
  road.moving = moving_lanes_of(tags, lane_class);
  for (const Flow flow : kFlows)
    road.roadsides[flow] = roadside_of(tags, lane_class, flow, road.moving.has_cycle_lane[flow]);
  const auto width_m = credible_width_m(tags, road.roadsides, road.moving);
  share_widths(tags, lane_class, width_m, road.roadsides, road.moving);

  CrossSection section{in_row(road), axis_from_backward_edge_m(tags, road)};
  if (tags.side == DrivingSide::kLeft) {
    std::reverse(section.lanes.begin(), section.lanes.end());
    section.axis_offset_m = carriageway_width_m(section) - section.axis_offset_m;
  }
  return {std::move(section), width_m || has_listed_widths(tags), has_placement(tags)};
}

}  // namespace

TaggedSection tagged_section_of(const ReadContext& context, OsmId id, source::Range tags, DrivingSide side,
                                RoadGuidelines guidelines) {
  LaneTags lane_tags{context, id, tags, side, guidelines};
  lane_tags.traffic = traffic_of(lane_tags);
  const LaneClass lane_class = lane_class_of(lane_tags);
  if (lane_class.is_road) return road_section(lane_tags, lane_class);
  return {lone_lane(lane_tags, lane_class), tagged_width_m(lane_tags).has_value(), false};
}

CrossSection cross_section_of(const ReadContext& context, OsmId id, source::Range tags, DrivingSide side) {
  return tagged_section_of(context, id, tags, side).section;
}

}  // namespace citykiln::map

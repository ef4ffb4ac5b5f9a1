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
  return {{{lane_class.kind, way, width_m, 0, false}}, width_m / 2};
}

// From the backward roadside to the forward one: left to right where one drives on the right.
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

CrossSection road_section(const LaneTags& tags, const LaneClass& lane_class) {
  diagnose_widths_beside(tags);
  Carriageway road;
  road.moving = moving_lanes_of(tags, lane_class);
  for (const Flow flow : kFlows)
    road.roadsides[flow] = roadside_of(tags, lane_class, flow, road.moving.has_cycle_lane[flow]);
  share_widths(tags, lane_class, road.roadsides, road.moving);

  CrossSection section{in_row(road), axis_from_backward_edge_m(tags, road)};
  if (tags.side == DrivingSide::kRight) return section;
  std::reverse(section.lanes.begin(), section.lanes.end());
  section.axis_offset_m = carriageway_width_m(section) - section.axis_offset_m;
  return section;
}

char letter_of(LaneKind kind) {
  switch (kind) {
    case LaneKind::kDriving:
      return 'd';
    case LaneKind::kBus:
      return 'b';
    case LaneKind::kTurn:
      return 't';
    case LaneKind::kCycle:
      return 'c';
    case LaneKind::kParking:
      return 'p';
    case LaneKind::kShoulder:
      return 'S';
    case LaneKind::kBuffer:
      return '/';
    case LaneKind::kSidewalk:
      return 's';
    case LaneKind::kFoot:
      return 'f';
    case LaneKind::kRail:
      return 'r';
    case LaneKind::kVerge:
      return 'g';
    case LaneKind::kCount:
      break;
  }
  return '?';
}

char letter_of(LaneDirection way) {
  return way == LaneDirection::kForward ? '^' : way == LaneDirection::kBackward ? 'v' : '-';
}

}  // namespace

CrossSection cross_section_of(const ReadContext& context, OsmId id, source::Range tags, DrivingSide side) {
  LaneTags lane_tags{context, id, tags, side};
  lane_tags.traffic = traffic_of(lane_tags);
  const LaneClass lane_class = lane_class_of(lane_tags);
  return lane_class.is_road ? road_section(lane_tags, lane_class) : lone_lane(lane_tags, lane_class);
}

double carriageway_width_m(const CrossSection& section) {
  double sum = 0;
  for (const Lane& lane : section.lanes) sum += lane.is_raised ? 0 : lane.width_m;
  return sum;
}

double total_width_m(const CrossSection& section) {
  double sum = 0;
  for (const Lane& lane : section.lanes) sum += lane.width_m;
  return sum;
}

std::string to_string(const CrossSection& section) {
  std::string kinds, ways;
  bool is_raised = !section.lanes.empty() && section.lanes.front().is_raised;
  for (const Lane& lane : section.lanes) {
    if (lane.is_raised != is_raised) kinds += '|', ways += '|';
    is_raised = lane.is_raised;
    kinds += letter_of(lane.kind);
    ways += letter_of(lane.way);
  }
  return kinds + " " + ways;
}

}  // namespace citykiln::map

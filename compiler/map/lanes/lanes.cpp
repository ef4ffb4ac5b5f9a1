#include "compiler/map/lanes/lanes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/map/lanes/lane_flows.h"
#include "compiler/map/lanes/lane_roadside.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

// ---- placement ------------------------------------------------------------------------------------------------------

// All lanes of a road with their widths.
struct Carriageway {
  MovingLanes moving;
  PerFlow<std::vector<RoadsideLane>> roadsides;
};

double sum_m(const std::vector<Lane>& lanes) {
  double sum = 0;
  for (const Lane& lane : lanes) sum += lane.width_m;
  return sum;
}

// The width of a roadside's level lanes, and the part of it that width=* does not count.
double level_m(const std::vector<RoadsideLane>& roadside) {
  double sum = 0;
  for (const RoadsideLane& beside : roadside) sum += beside.lane.is_raised ? 0 : beside.lane.width_m;
  return sum;
}
double outside_m(const std::vector<RoadsideLane>& roadside) {
  double sum = level_m(roadside);
  for (const RoadsideLane& beside : roadside) sum -= beside.inside_m;
  return sum;
}

// The position that a key's value like "right_of:2" names, in metres outwards from the flow's inner edge.
std::optional<double> placed_m(const LaneTags& tags, const std::vector<Lane>& lanes, std::string_view key) {
  const std::string_view text = tags(key);
  const std::size_t colon = text.find(':');
  const std::string_view where = text.substr(0, colon);
  const double number = number_of(text.substr(std::min(colon, text.size() - 1) + 1)).value_or(0);
  const bool is_known = where == "left_of" || where == "middle_of" || where == "right_of";
  if (!is_known || number < 1 || number > static_cast<double>(lanes.size())) {
    if (text != "transition") tags.add_bad_value(key);
    return std::nullopt;
  }
  // lanes are counted from the driver's left: the middle of the road with traffic on the right
  const bool is_left_inside = tags.side == DrivingSide::kRight;
  const auto nth = static_cast<std::size_t>(number) - 1;
  const std::size_t index = is_left_inside ? nth : lanes.size() - 1 - nth;
  double out_m = 0;
  for (std::size_t i = 0; i < index; ++i) out_m += lanes[i].width_m;
  if (where == "middle_of") return out_m + lanes[index].width_m / 2;
  return (where == "right_of") == is_left_inside ? out_m + lanes[index].width_m : out_m;
}

// placement=* without a direction is for one-way roads; on two-way roads it applies to the forward lanes.
std::string placement_key_of(const LaneTags& tags, Flow flow) {
  std::string directed = tags.key_along(flow, "placement");
  if (!tags(directed).empty() || tags.is_one_way() || flow == Flow::kBackward) return directed;
  return "placement";
}

// Returns the distance of the way from the carriageway's edge on the backward flow's side. It follows from
// placement=*; else the way lies in the middle of the width that width=* states (moving lanes, cycle lanes and cars
// parked on the carriageway, without bays and shoulders). placement=transition leaves it there
// (transitions.h moves it). Diagnosed: kBadTagValue for a lane that does not exist.
double axis_from_backward_edge_m(const LaneTags& tags, const Carriageway& road) {
  assert(std::ranges::none_of(road.moving.middle, [](const Lane& lane) { return lane.width_m <= 0; }));
  const MovingLanes& moving = road.moving;
  const double to_middle_m = level_m(road.roadsides[Flow::kBackward]) + sum_m(moving.flows[Flow::kBackward]);
  const double past_middle_m = to_middle_m + sum_m(moving.middle);
  for (const Flow flow : kFlows) {
    const std::string key = placement_key_of(tags, flow);
    if (tags(key).empty()) continue;
    if (const auto out_m = placed_m(tags, moving.flows[flow], key))
      return flow == Flow::kForward ? past_middle_m + *out_m : to_middle_m - *out_m;
  }
  const double whole_m = past_middle_m + sum_m(moving.flows[Flow::kForward]) + level_m(road.roadsides[Flow::kForward]);
  return (outside_m(road.roadsides[Flow::kBackward]) + whole_m - outside_m(road.roadsides[Flow::kForward])) / 2;
}

// ---- widths ---------------------------------------------------------------------------------------------------------

constexpr double kLeastWidth_m = 0.3, kMostWidth_m = 80;

// A row of parked cars that no tag states.
constexpr double kUntaggedParking_m = 2.5;

double inside_m(const PerFlow<std::vector<RoadsideLane>>& roadsides) {
  double sum = 0;
  for (const Flow flow : kFlows)
    for (const RoadsideLane& lane : roadsides[flow]) sum += lane.inside_m;
  return sum;
}

// Divides a width into whole quanta; the first lanes get one more each if it does not divide evenly.
void share(double width_m, std::span<Lane* const> lanes) {
  const auto quanta = static_cast<std::int64_t>(std::llround(width_m / kQuantum_m));
  const auto n = static_cast<std::int64_t>(lanes.size());
  for (std::int64_t i = 0; i < n; ++i)
    lanes[static_cast<std::size_t>(i)]->width_m =
        static_cast<double>(quanta / n + (i < quanta % n ? 1 : 0)) * kQuantum_m;
}

// Merges two lanes that no tag counted into one, of their flow or of both.
void merge_two_lanes(MovingLanes& moving) {
  const std::vector<Lane*> lanes = moving.all();
  if (moving.is_tagged || lanes.size() != 2 || lanes[0]->kind != lanes[1]->kind) return;
  Lane one = *lanes[0];
  std::vector<Lane>& place = one.way == lanes[1]->way && one.way != LaneDirection::kBoth
                                 ? moving.flows[one.way == LaneDirection::kForward ? Flow::kForward : Flow::kBackward]
                                 : moving.middle;
  if (one.way != lanes[1]->way) one.way = LaneDirection::kBoth;
  for (const Flow flow : kFlows) moving.flows[flow].clear();
  place = {one};
}

// Diagnoses the tag of the width, which contradicts the lanes.
void add_bad_width(const LaneTags& tags) { tags.add_bad_value(tags("width").empty() ? "est_width" : "width"); }

// True if a width of the carriageway can be that of these lanes.
bool is_credible(double width_m, const PerFlow<std::vector<RoadsideLane>>& roadsides, const MovingLanes& moving) {
  if (!moving.is_tagged) return true;
  double beside_m = inside_m(roadsides);
  for (const Flow flow : kFlows)
    if (std::ranges::all_of(roadsides[flow], [](const RoadsideLane& beside) { return beside.lane.is_raised; }))
      beside_m += kUntaggedParking_m;
  return width_m - beside_m <= kWidestLane_m * moving.counted;
}

// Returns width=*, else est_width=*, in metres: snapped, at least 2^-10. Unreadable values are diagnosed.
std::optional<double> tagged_width_m(const LaneTags& tags) {
  for (const char* key : {"width", "est_width"})
    if (const auto tagged = tagged_length_m(tags.context, tags.id, tags.tags, key, kLeastWidth_m, kMostWidth_m))
      return std::max(kQuantum_m, snapped(*tagged));
  return std::nullopt;
}

// Returns tagged_width_m() unless it is too large for the tagged number of lanes: each would be wider than
// kWidestLane_m, even with a row of parked cars on every side without tagged lanes inside the kerb. Some imports state
// the width of the whole street, from house to house. Diagnosed: kBadTagValue.
std::optional<double> credible_width_m(const LaneTags& tags, const PerFlow<std::vector<RoadsideLane>>& roadsides,
                                       const MovingLanes& moving) {
  const auto tagged_m = tagged_width_m(tags);
  if (!tagged_m || is_credible(*tagged_m, roadsides, moving)) return tagged_m;
  add_bad_width(tags);
  return std::nullopt;
}

// Sets the width of all lanes that width:lanes does not state. A credible width=*, less the roadsides, is divided
// evenly; odd quanta go to the lanes in the middle, then to the forward lanes. Without it each lane has the class's
// width. Two lanes that no tag counts become one if two cars could not pass. Diagnosed: a width=* that is too small
// for its lanes.
// @param tagged_m  credible_width_m().
void share_widths(const LaneTags& tags, const LaneClass& lane_class, std::optional<double> tagged_m,
                  const PerFlow<std::vector<RoadsideLane>>& roadsides, MovingLanes& moving) {
  assert(!moving.all().empty());
  const double inside = inside_m(roadsides);
  if (tagged_m && *tagged_m - inside < kNarrowestMeeting_m) merge_two_lanes(moving);

  // widths that width:lanes has set
  double listed_m = 0, driven = 0;
  std::vector<Lane*> open;
  for (Lane* lane : moving.all()) {
    listed_m += lane->width_m;
    driven += lane->kind == LaneKind::kCycle ? 0 : 1;
    if (lane->width_m == 0) open.push_back(lane);
  }
  if (open.empty()) return;
  const auto n = static_cast<double>(open.size());
  double rest_m = snapped(lane_class.width_m_of(moving.counted));
  // the other lanes have the width they would have without width:lanes
  if (listed_m > 0) rest_m = snapped(lane_class.width_m_of(driven) * n / driven);
  if (tagged_m) {
    rest_m = *tagged_m - inside - listed_m;
    const bool is_alone = open.size() == 1 && inside + listed_m == 0;
    if (!is_alone && rest_m < n * kNarrowestLane_m) {
      add_bad_width(tags);
      rest_m = n * kNarrowestLane_m;
    }
  }
  share(rest_m, open);
}

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

bool is_transition(const LaneTags& tags) {
  bool is_one = false;
  for (const char* key : {"placement", "placement:forward", "placement:backward"}) {
    if (!tags(key).empty() && tags(key) != "transition") return false;
    is_one |= !tags(key).empty();
  }
  return is_one;
}

bool has_listed_widths(const LaneTags& tags) {
  return !tags("width:lanes").empty() || !tags("width:lanes:forward").empty() || !tags("width:lanes:backward").empty();
}

// The sides of the road for which a test of a flow's roadside holds.
std::uint8_t sides_where(const LaneTags& tags, bool (*says)(const LaneTags&, Flow)) {
  unsigned sides = 0;
  for (const Flow flow : kFlows)
    if (says(tags, flow)) sides |= tags.roadside(flow) == "left" ? kLeftSide : kRightSide;
  return static_cast<std::uint8_t>(sides);
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
  return {.section = std::move(section),
          .has_width = width_m || has_listed_widths(tags),
          .has_placement = has_placement(tags),
          .tagged_pavements = sides_where(tags, says_pavement),
          .fixed_pavements = sides_where(tags, fixes_pavement),
          .tagged_verges = sides_where(tags, says_verge),
          // listed widths are those of the moving lanes alone
          .tagged_parking = has_listed_widths(tags) ? std::uint8_t{kBothSides} : sides_where(tags, says_parking),
          .is_transition = is_transition(tags)};
}

}  // namespace

TaggedSection tagged_section_of(const ReadContext& context, OsmId id, source::Range tags, DrivingSide side,
                                RoadGuidelines guidelines) {
  LaneTags lane_tags{context, id, tags, side, guidelines};
  lane_tags.traffic = traffic_of(lane_tags);
  const LaneClass lane_class = lane_class_of(lane_tags);
  if (lane_class.is_road) return road_section(lane_tags, lane_class);
  // such ways have neither pavements nor verges nor parked cars
  return {.section = lone_lane(lane_tags, lane_class),
          .has_width = tagged_width_m(lane_tags).has_value(),
          .tagged_pavements = kBothSides,
          .fixed_pavements = kBothSides,
          .tagged_verges = kBothSides,
          .tagged_parking = kBothSides};
}

}  // namespace citykiln::map

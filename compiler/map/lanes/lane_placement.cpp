#include "compiler/map/lanes/lane_placement.h"

#include <algorithm>
#include <cassert>

#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

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

}  // namespace

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

}  // namespace citykiln::map

#include "compiler/map/lanes/lane_counts.h"

#include <algorithm>
#include <cmath>

#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

// What the tags say of numbers, each nothing where it says nothing.
struct Told {
  std::optional<double> total;
  PerFlow<std::optional<int>> directed;
  std::optional<int> both_ways;
};

std::optional<int> whole(std::optional<double> number) {
  return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

Told told_by(const LaneTags& tags) {
  Told told;
  told.total = tags.count("lanes", 1);
  for (const Flow flow : kFlows) told.directed[flow] = whole(tags.count("lanes" + std::string(tags.suffix(flow)), 0));
  told.both_ways = whole(tags.count("lanes:both_ways", 0));
  if (!told.both_ways && says_yes(tags("centre_turn_lane"))) told.both_ways = 1;
  if (told.both_ways) told.both_ways = std::min(*told.both_ways, 2);
  return told;
}

bool says_turning(const LaneTags& tags) {
  bool is_known = true;
  const std::uint16_t turns = turns_of(tags("turn:lanes:both_ways"), is_known);
  return turns != kTurnThrough;
}

// The class's number: a one-way road of a class with two lanes has one, but for motorways.
int untold_lanes(const LaneTags& tags, const LaneClass& lane_class) {
  const int lanes = std::max(lane_class.lanes, 1);
  return lanes == 2 && tags.traffic != Traffic::kTwoWay && !lane_class.is_motorway ? 1 : lanes;
}

bool tells_contraflow_bus(const LaneTags& tags, Flow flow) {
  const std::string_view beside = tags.beside(flow, "busway");
  return beside == "opposite_lane" || tags("busway") == "opposite_lane" || tags("psv") == "opposite_lane" ||
         tags("bus") == "opposite_lane";
}

// A lane of buses against the traffic: tagged as one, or lanes counted against oneway=yes.
int contraflow_lanes(const LaneTags& tags, const Told& told) {
  const Flow other = opposite(tags.only_flow());
  if (told.directed[other]) return std::min(*told.directed[other], 2);
  for (const char* key : {"lanes:bus", "lanes:psv"})
    if (says_yes(tags(key + std::string(tags.suffix(other))))) return 1;
  return tells_contraflow_bus(tags, other) ? 1 : 0;
}

LaneCounts count_one_way(const LaneTags& tags, const LaneClass& lane_class, const Told& told, const LaneList& list) {
  LaneCounts counts;
  const Flow flow = tags.only_flow();
  const int against = contraflow_lanes(tags, told);
  const auto along = told.directed[flow];
  // lanes=* counts the contraflow lane too, but one lane alone is the traffic's
  const std::optional<int> rest =
      told.total ? std::optional(std::max(static_cast<int>(*told.total) - against, 1)) : std::nullopt;
  if (along && *along > 0)
    counts.flows[flow] = *along;
  else if (rest)
    counts.flows[flow] = *rest;
  else
    counts.flows[flow] = list.driven_count() > 0 ? list.driven_count() : untold_lanes(tags, lane_class);
  if (along && rest && *along != *rest) tags.add_bad_value();
  counts.flows[opposite(flow)] = against;
  counts.is_contraflow_bus = against > 0;
  return counts;
}

LaneCounts count_in_turns(const LaneTags& tags, const LaneClass& lane_class, const Told& told) {
  LaneCounts counts;
  counts.in_middle = told.total ? static_cast<int>(*told.total) : untold_lanes(tags, lane_class);
  return counts;
}

// Both directions share what is left of the total; the odd lane is both's. Beside a turning lane each has at least one.
void share_rest(LaneCounts& counts, int rest) {
  if (counts.in_middle > 0) rest = std::max(rest, 2);
  for (const Flow flow : kFlows) counts.flows[flow] = rest / 2;
  counts.in_middle += rest % 2;
}

// Lengths of lists tell the numbers lanes:forward and lanes:backward do not, where lanes=* leaves room for them.
void read_list_lengths(Told& told, const PerFlow<LaneList>& lists) {
  PerFlow<std::optional<int>> directed = told.directed;
  int sum = told.both_ways.value_or(0);
  for (const Flow flow : kFlows) {
    const int listed = lists[flow].driven_count();
    if (!directed[flow] && listed > 0) directed[flow] = listed;
    sum += std::max(directed[flow].value_or(1), 1);
  }
  if (!told.total || sum <= *told.total) told.directed = directed;
}

LaneCounts count_two_way(const LaneTags& tags, const LaneClass& lane_class, Told told, const PerFlow<LaneList>& lists) {
  LaneCounts counts;
  counts.in_middle = told.both_ways.value_or(0);
  counts.is_middle_to_turn = counts.in_middle > 0 && says_turning(tags);
  read_list_lengths(told, lists);
  const auto forward = told.directed[Flow::kForward], backward = told.directed[Flow::kBackward];
  const int total = told.total ? static_cast<int>(*told.total) : 0;
  if (!forward && !backward) {
    share_rest(counts, told.total ? total - counts.in_middle : untold_lanes(tags, lane_class));
  } else {
    for (const Flow flow : kFlows) {
      const int left = total - counts.in_middle - told.directed[opposite(flow)].value_or(0);
      counts.flows[flow] = told.directed[flow] ? *told.directed[flow] : std::max(left, 1);
    }
  }
  if (told.total && counts.total() != total) tags.add_bad_value();
  return counts;
}

LaneCounts counts_told(const LaneTags& tags, const LaneClass& lane_class, const Told& told,
                       const PerFlow<LaneList>& lists) {
  if (tags.traffic == Traffic::kInTurns) return count_in_turns(tags, lane_class, told);
  if (tags.is_one_way()) return count_one_way(tags, lane_class, told, lists[tags.only_flow()]);
  return count_two_way(tags, lane_class, told, lists);
}

}  // namespace

LaneCounts lane_counts_of(const LaneTags& tags, const LaneClass& lane_class, const PerFlow<LaneList>& lists) {
  const Told told = told_by(tags);
  LaneCounts counts = counts_told(tags, lane_class, told, lists);
  if (counts.total() == 0 || counts.total() > kMaxLanesOfRoad) {
    tags.add_bad_value();
    counts = counts_told(tags, lane_class, {}, {});
  }
  for (const Flow flow : kFlows) counts.is_tagged |= told.directed[flow].has_value() || !lists[flow].lanes.empty();
  counts.is_tagged |= told.total.has_value() || counts.in_middle > 1 || counts.is_middle_to_turn;
  // a roundabout's one lane is as wide as its class's two, unless oneway=* is tagged and takes one away
  const bool is_implied_one_way = tags.is_one_way() && tags("oneway").empty();
  counts.counted = counts.total();
  if (!counts.is_tagged && is_implied_one_way) counts.counted = std::max(lane_class.lanes, 1);
  if (told.total && counts.total() == static_cast<int>(*told.total)) counts.counted = *told.total;
  return counts;
}

}  // namespace citykiln::map

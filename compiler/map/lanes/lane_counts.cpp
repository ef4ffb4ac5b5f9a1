#include "compiler/map/lanes/lane_counts.h"

#include <algorithm>
#include <cmath>

#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

// The numbers of lanes by tags; nothing where untagged.
struct TaggedCounts {
  std::optional<double> total;
  PerFlow<std::optional<int>> directed;
  std::optional<int> both_ways;
};

std::optional<int> whole(std::optional<double> number) {
  return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

TaggedCounts tagged_counts(const LaneTags& tags) {
  TaggedCounts tagged;
  tagged.total = tags.count("lanes", 1);
  for (const Flow flow : kFlows) tagged.directed[flow] = whole(tags.count("lanes" + std::string(tags.suffix(flow)), 0));
  tagged.both_ways = whole(tags.count("lanes:both_ways", 0));
  if (!tagged.both_ways && says_yes(tags("centre_turn_lane"))) tagged.both_ways = 1;
  if (tagged.both_ways) tagged.both_ways = std::min(*tagged.both_ways, 2);
  return tagged;
}

bool says_turning(const LaneTags& tags) {
  bool is_known = true;
  const std::uint16_t turns = turns_of(tags("turn:lanes:both_ways"), is_known);
  return turns != kTurnThrough;
}

// The default of the class. A one-way road of a class with two lanes has one, except motorways.
int default_lanes(const LaneTags& tags, const LaneClass& lane_class) {
  const int lanes = std::max(lane_class.lanes, 1);
  return lanes == 2 && tags.traffic != Traffic::kTwoWay && !lane_class.is_motorway ? 1 : lanes;
}

bool has_contraflow_bus_tag(const LaneTags& tags, Flow flow) {
  const std::string_view beside = tags.beside(flow, "busway");
  return beside == "opposite_lane" || tags("busway") == "opposite_lane" || tags("psv") == "opposite_lane" ||
         tags("bus") == "opposite_lane";
}

// The number of bus lanes against the traffic: tagged as such, or lanes counted against oneway=yes.
int contraflow_lanes(const LaneTags& tags, const TaggedCounts& tagged) {
  const Flow other = opposite(tags.only_flow());
  if (tagged.directed[other]) return std::min(*tagged.directed[other], 2);
  for (const char* key : {"lanes:bus", "lanes:psv"})
    if (says_yes(tags(key + std::string(tags.suffix(other))))) return 1;
  return has_contraflow_bus_tag(tags, other) ? 1 : 0;
}

LaneCounts count_one_way(const LaneTags& tags, const LaneClass& lane_class, const TaggedCounts& tagged,
                         const LaneList& list) {
  LaneCounts counts;
  const Flow flow = tags.only_flow();
  const int against = contraflow_lanes(tags, tagged);
  const auto along = tagged.directed[flow];
  // lanes=* includes the contraflow lane, except where it is 1
  const std::optional<int> rest =
      tagged.total ? std::optional(std::max(static_cast<int>(*tagged.total) - against, 1)) : std::nullopt;
  if (along && *along > 0)
    counts.flows[flow] = *along;
  else if (rest)
    counts.flows[flow] = *rest;
  else
    counts.flows[flow] = list.driven_count() > 0 ? list.driven_count() : default_lanes(tags, lane_class);
  if (along && rest && *along != *rest) tags.add_bad_count();
  counts.flows[opposite(flow)] = against;
  counts.is_contraflow_bus = against > 0;
  return counts;
}

LaneCounts count_in_turns(const LaneTags& tags, const LaneClass& lane_class, const TaggedCounts& tagged) {
  LaneCounts counts;
  counts.in_middle = tagged.total ? static_cast<int>(*tagged.total) : default_lanes(tags, lane_class);
  return counts;
}

// Divides the rest of the total between the directions; an odd lane goes to both. Beside a turning lane each direction
// has at least one.
void share_rest(LaneCounts& counts, int rest) {
  if (counts.in_middle > 0) rest = std::max(rest, 2);
  for (const Flow flow : kFlows) counts.flows[flow] = rest / 2;
  counts.in_middle += rest % 2;
}

// Fills lanes:forward and lanes:backward from the lengths of lists, where lanes=* leaves room.
void read_list_lengths(TaggedCounts& tagged, const PerFlow<LaneList>& lists) {
  PerFlow<std::optional<int>> directed = tagged.directed;
  int sum = tagged.both_ways.value_or(0);
  for (const Flow flow : kFlows) {
    const int listed = lists[flow].driven_count();
    if (!directed[flow] && listed > 0) directed[flow] = listed;
    sum += std::max(directed[flow].value_or(1), 1);
  }
  if (!tagged.total || sum <= *tagged.total) tagged.directed = directed;
}

LaneCounts count_two_way(const LaneTags& tags, const LaneClass& lane_class, TaggedCounts tagged,
                         const PerFlow<LaneList>& lists) {
  LaneCounts counts;
  counts.in_middle = tagged.both_ways.value_or(0);
  counts.is_middle_to_turn = counts.in_middle > 0 && says_turning(tags);
  read_list_lengths(tagged, lists);
  const auto forward = tagged.directed[Flow::kForward], backward = tagged.directed[Flow::kBackward];
  const int total = tagged.total ? static_cast<int>(*tagged.total) : 0;
  if (!forward && !backward) {
    share_rest(counts, tagged.total ? total - counts.in_middle : default_lanes(tags, lane_class));
  } else {
    for (const Flow flow : kFlows) {
      const int left = total - counts.in_middle - tagged.directed[opposite(flow)].value_or(0);
      counts.flows[flow] = tagged.directed[flow] ? *tagged.directed[flow] : std::max(left, 1);
    }
  }
  if (tagged.total && counts.total() != total) tags.add_bad_count();
  return counts;
}

LaneCounts counts_by_tags(const LaneTags& tags, const LaneClass& lane_class, const TaggedCounts& tagged,
                          const PerFlow<LaneList>& lists) {
  if (tags.traffic == Traffic::kInTurns) return count_in_turns(tags, lane_class, tagged);
  if (tags.is_one_way()) return count_one_way(tags, lane_class, tagged, lists[tags.only_flow()]);
  return count_two_way(tags, lane_class, tagged, lists);
}

}  // namespace

LaneCounts lane_counts_of(const LaneTags& tags, const LaneClass& lane_class, const PerFlow<LaneList>& lists) {
  const TaggedCounts tagged = tagged_counts(tags);
  LaneCounts counts = counts_by_tags(tags, lane_class, tagged, lists);
  if (counts.total() == 0 || counts.total() > kMaxLanesOfRoad) {
    tags.add_bad_count();
    counts = counts_by_tags(tags, lane_class, {}, {});
  }
  for (const Flow flow : kFlows) counts.is_tagged |= tagged.directed[flow].has_value() || !lists[flow].lanes.empty();
  counts.is_tagged |= tagged.total.has_value() || counts.in_middle > 1 || counts.is_middle_to_turn;
  // an untagged roundabout has one lane as wide as its class's two; an explicit oneway=* takes one away
  const bool is_implied_one_way = tags.is_one_way() && tags("oneway").empty();
  counts.counted = counts.total();
  if (!counts.is_tagged && is_implied_one_way) counts.counted = std::max(lane_class.lanes, 1);
  if (tagged.total && counts.total() == static_cast<int>(*tagged.total)) counts.counted = *tagged.total;
  return counts;
}

}  // namespace citykiln::map

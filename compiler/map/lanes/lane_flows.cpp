#include "compiler/map/lanes/lane_flows.h"

#include <algorithm>

#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

using Lanes = std::vector<Lane>;

Lanes plain_lanes(int count, LaneKind kind, LaneDirection way) {
  return Lanes(static_cast<std::size_t>(count), Lane{.kind = kind, .way = way});
}

bool has_cycle_lane_beside(const LaneTags& tags, Flow flow) {
  const std::string_view beside = tags.beside(flow, "cycleway");
  return (beside.empty() ? tags("cycleway") : beside) == "lane";
}

// True where the flow's lists agree with its number of lanes. They may contain a cycle lane beside the road that
// bicycle:lanes does not name, or one that lanes=* counts.
bool fit(const LaneTags& tags, Flow flow, LaneList& list, int& count) {
  const int size = static_cast<int>(list.lanes.size());
  if (list.driven_count() == count) return true;
  if (list.cycle_count() == 0 && size == count + 1 && has_cycle_lane_beside(tags, flow)) {
    list.lanes.pop_back();
    return true;
  }
  tags.add_bad_count();
  if (size != count || list.driven_count() == 0) return false;
  count = list.driven_count();
  return true;
}

Lanes listed_flow(const LaneList& list, LaneKind kind, LaneDirection way) {
  Lanes lanes;
  for (const ListedLane& listed : list.lanes) {
    const LaneKind own = listed.kind == LaneKind::kDriving ? kind : listed.kind;
    const double width_m = listed.width_m == 0 && own == LaneKind::kCycle ? kCycleLane_m : listed.width_m;
    lanes.push_back({.kind = own, .way = way, .width_m = width_m, .turns = listed.turns});
  }
  return lanes;
}

int count_of(const Lanes& lanes, LaneKind kind) {
  return static_cast<int>(std::count_if(lanes.begin(), lanes.end(), [&](const Lane& l) { return l.kind == kind; }));
}

// Turns the driving lane nearest to an edge into a bus lane. Where it is the only one, adds a bus lane at that edge.
void reserve_for_buses(MovingLanes& moving, Flow flow, bool at_outer_edge) {
  Lanes& lanes = moving.flows[flow];
  const auto is_driven = [](const Lane& lane) { return lane.kind == LaneKind::kDriving; };
  if (count_of(lanes, LaneKind::kDriving) > 1) {
    if (at_outer_edge)
      std::find_if(lanes.rbegin(), lanes.rend(), is_driven)->kind = LaneKind::kBus;
    else
      std::find_if(lanes.begin(), lanes.end(), is_driven)->kind = LaneKind::kBus;
    return;
  }
  const Lane bus{.kind = LaneKind::kBus, .way = way_of(flow)};
  lanes.insert(at_outer_edge ? lanes.end() : lanes.begin(), bus);
  moving.counted += 1;
}

// Reads a count like "2" or "yes".
int bus_count(const LaneTags& tags, const std::string& key) {
  if (tags(key) == "yes") return 1;
  return static_cast<int>(tags.count(key, 0).value_or(0));
}

bool is_busway(std::string_view value) { return value == "lane" || value == "yes"; }

// True for a busway beside the flow's outer lane.
bool has_busway_beside(const LaneTags& tags, Flow flow) {
  const std::string_view beside = tags.beside(flow, "busway"), plain = tags("busway");
  if (!beside.empty()) return is_busway(beside);
  if (plain == "right_lane" || plain == "left_lane") return plain.starts_with(tags.roadside(flow));
  return is_busway(plain) && tags.has(flow);
}

int tagged_bus_lanes(const LaneTags& tags, Flow flow) {
  const std::string suffix(tags.suffix(flow));
  return std::max({bus_count(tags, "lanes:bus" + suffix), bus_count(tags, "lanes:psv" + suffix),
                   has_busway_beside(tags, flow) ? 1 : 0});
}

// lanes:bus=n and lanes:psv=n give no direction: two-way roads have half of them each way.
int undirected_bus_lanes(const LaneTags& tags) {
  const int tagged = std::max(bus_count(tags, "lanes:bus"), bus_count(tags, "lanes:psv"));
  return tags.is_one_way() ? tagged : tagged / 2;
}

void reserve_for_buses(const LaneTags& tags, MovingLanes& moving) {
  const int undirected = undirected_bus_lanes(tags);
  const bool at_inner_edge = tags.is_one_way() && has_busway_beside(tags, opposite(tags.only_flow()));
  for (const Flow flow : kFlows) {
    if (!tags.has(flow) || count_of(moving.flows[flow], LaneKind::kBus) > 0) continue;
    const int outside = tagged_bus_lanes(tags, flow);
    // a busway on the inner side is not taken from the outer side as well
    const int inside = at_inner_edge ? 1 : 0;
    const int count = std::min(std::max(outside, undirected - inside), kMaxLanes / 4);
    for (int i = 0; i < count; ++i) reserve_for_buses(moving, flow, true);
    if (at_inner_edge) reserve_for_buses(moving, flow, false);
  }
}

}  // namespace

std::vector<Lane*> MovingLanes::all() {
  std::vector<Lane*> lanes;
  for (Lane& lane : middle) lanes.push_back(&lane);
  for (const Flow flow : kFlows)
    for (Lane& lane : flows[flow]) lanes.push_back(&lane);
  return lanes;
}

MovingLanes moving_lanes_of(const LaneTags& tags, const LaneClass& lane_class) {
  PerFlow<LaneList> lists;
  for (const Flow flow : kFlows) lists[flow] = listed_lanes(tags, flow);
  LaneCounts counts = lane_counts_of(tags, lane_class, lists);
  MovingLanes moving;
  moving.counted = counts.counted;
  moving.is_tagged = counts.is_tagged;
  for (const Flow flow : kFlows) {
    const LaneKind kind = counts.is_contraflow_bus && !tags.has(flow) ? LaneKind::kBus : lane_class.kind;
    const int before = counts.flows[flow];
    const bool is_listed = !lists[flow].lanes.empty() && fit(tags, flow, lists[flow], counts.flows[flow]);
    moving.flows[flow] =
        is_listed ? listed_flow(lists[flow], kind, way_of(flow)) : plain_lanes(counts.flows[flow], kind, way_of(flow));
    moving.has_cycle_lane[flow] = count_of(moving.flows[flow], LaneKind::kCycle) > 0;
    moving.counted -= before - counts.flows[flow];
  }
  moving.middle =
      plain_lanes(counts.in_middle, counts.is_middle_to_turn ? LaneKind::kTurn : lane_class.kind, LaneDirection::kBoth);
  // on a one-way road the cycle lane lies between both roadsides
  if (tags.is_one_way()) moving.has_cycle_lane[opposite(tags.only_flow())] |= moving.has_cycle_lane[tags.only_flow()];
  bool is_known = true;
  if (counts.is_middle_to_turn)
    for (Lane& lane : moving.middle) lane.turns = turns_of(tags("turn:lanes:both_ways"), is_known);
  if (!is_known) tags.add_bad_value("turn:lanes:both_ways");
  if (lane_class.kind == LaneKind::kDriving) reserve_for_buses(tags, moving);
  return moving;
}

}  // namespace citykiln::map

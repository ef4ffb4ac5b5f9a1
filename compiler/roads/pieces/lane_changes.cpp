#include "compiler/roads/pieces/lane_changes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <tuple>

#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/taper.h"

namespace citykiln::roads {
namespace {

using map::Lane;
using map::LaneDirection;
using map::LaneKind;

// The lanes between the kerbs on one side of a change, left to right as seen from the first arm to the second, and
// their edges, to the left positive.
struct LanesBeside {
  std::vector<Lane> lanes;
  std::vector<double> edges_m;
  bool is_left_hand = false;
};

// True if the way of an arm runs from the second arm to the first.
bool runs_against(const Arm& arm, bool is_first) { return (arm.step > 0) == is_first; }

Lane seen_backwards(Lane lane) {
  if (lane.way == LaneDirection::kBoth) return lane;
  lane.way = lane.way == LaneDirection::kForward ? LaneDirection::kBackward : LaneDirection::kForward;
  return lane;
}

LanesBeside lanes_beside(std::span<const Road> roads, const Arm& arm, bool is_first) {
  const Road& road = roads[arm.road];
  LanesBeside side{{}, {}, road.side == map::DrivingSide::kLeft};
  for (const Lane& lane : road.section.lanes)
    if (!lane.is_raised) side.lanes.push_back(lane);
  if (runs_against(arm, is_first)) {
    std::ranges::reverse(side.lanes);
    for (Lane& lane : side.lanes) lane = seen_backwards(lane);
  }
  side.edges_m = {is_first ? arm_right_m(roads, arm) : arm_left_m(roads, arm)};
  for (const Lane& lane : side.lanes) side.edges_m.push_back(side.edges_m.back() - lane.width_m);
  return side;
}

// ---- matching -------------------------------------------------------------------------------------------------------

bool is_for_cars(const Lane& lane) {
  return lane.kind == LaneKind::kDriving || lane.kind == LaneKind::kBus || lane.kind == LaneKind::kTurn;
}

bool can_go_on(const Lane& a, const Lane& b) {
  if (is_for_cars(a) != is_for_cars(b) || (!is_for_cars(a) && a.kind != b.kind)) return false;
  return a.way == b.way || (!is_for_cars(a));
}

// Lanes whose arrows lead aside are more likely to be added ones.
bool turns_aside(const Lane& lane) { return lane.turns != 0 && (lane.turns & map::kTurnThrough) == 0; }

// How bad it is that lane i of the side with fewer lanes goes on as lane j of the other: the distance sideways. Among
// equals, outer lanes are added.
double cost_m(const LanesBeside& few, std::size_t i, const LanesBeside& many, std::size_t j) {
  constexpr double kAside_m = 8, kOuter_m = 0x1p-10;
  const auto middle_m = [](const LanesBeside& side, std::size_t k) {
    return (side.edges_m[k] + side.edges_m[k + 1]) / 2;
  };
  double sum_m = std::abs(middle_m(few, i) - middle_m(many, j));
  if (turns_aside(many.lanes[j]) && !turns_aside(few.lanes[i])) sum_m += kAside_m;
  const bool is_inner_left = (many.lanes[j].way == LaneDirection::kForward) != many.is_left_hand;
  return sum_m + kOuter_m * static_cast<double>(is_inner_left ? j : many.lanes.size() - 1 - j);
}

// The best matching of the first lanes of both sides: as many lanes as possible, then the lowest cost.
struct Matching {
  int count = 0;
  double cost_m = 0;
  bool is_matched = false;  // the last lanes of both go on as each other
  bool is_better_than(const Matching& other) const {
    return count != other.count ? count > other.count : cost_m < other.cost_m;
  }
};

using Match = std::vector<std::optional<std::size_t>>;

// Returns for each lane of one side the lane of the other as which it goes on. Lanes keep their order.
Match matched(const LanesBeside& few, const LanesBeside& many) {
  const std::size_t n = few.lanes.size(), m = many.lanes.size();
  std::vector<std::vector<Matching>> best(n + 1, std::vector<Matching>(m + 1));
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t j = 1; j <= m; ++j) {
      Matching here = best[i][j - 1];
      if (best[i - 1][j].is_better_than(here)) here = best[i - 1][j];
      here.is_matched = false;
      if (can_go_on(few.lanes[i - 1], many.lanes[j - 1])) {
        const Matching& before = best[i - 1][j - 1];
        const Matching both{before.count + 1, before.cost_m + cost_m(few, i - 1, many, j - 1), true};
        if (both.is_better_than(here)) here = both;
      }
      best[i][j] = here;
    }
  Match match(n);
  const auto is_as = [](const Matching& a, const Matching& b) { return a.count == b.count && a.cost_m == b.cost_m; };
  for (std::size_t i = n, j = m; i > 0 && j > 0;) {
    if (best[i][j].is_matched)
      match[--i] = --j;
    else
      is_as(best[i][j], best[i][j - 1]) ? --j : --i;
  }
  return match;
}

// ---- edges at the node ----------------------------------------------------------------------------------------------

// Returns where the line between lanes p and q of the side with more lanes goes on: with the line between the same
// directions if there is one between them, else with the nearest.
double line_between(const LanesBeside& many, std::size_t p, std::size_t q, double at_m) {
  const auto rank = [&](std::size_t edge) {
    const bool divides_alike =
        many.lanes[edge - 1].way == many.lanes[p].way && many.lanes[edge].way == many.lanes[q].way;
    return std::tuple(!divides_alike, std::abs(many.edges_m[edge] - at_m));
  };
  std::size_t best = p + 1;
  for (std::size_t edge = p + 2; edge <= q; ++edge)
    if (rank(edge) < rank(best)) best = edge;
  return many.edges_m[best];
}

// The edges of the side with fewer lanes at the node.
std::vector<double> led_edges(const LanesBeside& few, const LanesBeside& many) {
  std::vector<double> edges_m = few.edges_m;
  const Match match = matched(few, many);
  for (std::size_t i = 1; i < few.lanes.size(); ++i) {
    const auto left = match[i - 1], right = match[i];
    if (left && right)
      edges_m[i] = line_between(many, *left, *right, few.edges_m[i]);
    else if (left)
      edges_m[i] = many.edges_m[*left + 1];
    else if (right)
      edges_m[i] = many.edges_m[*right];
  }
  return edges_m;
}

// Moves the outermost edges to those that both sides share, and the others between them.
void clamp_edges(double left_m, double right_m, std::vector<double>& edges_m) {
  edges_m.front() = left_m, edges_m.back() = right_m;
  for (std::size_t i = 1; i + 1 < edges_m.size(); ++i) edges_m[i] = std::clamp(edges_m[i], right_m, edges_m[i - 1]);
}

// True if the second side leads: it has more lanes, or as many and is as wide.
bool second_leads(const LanesBeside& first, const LanesBeside& second) {
  const auto rank = [](const LanesBeside& s) {
    return std::pair(s.lanes.size(), s.edges_m.front() - s.edges_m.back());
  };
  return rank(second) >= rank(first);
}

// The edges of the carriageways of both sides at the node.
struct SharedEdges {
  std::vector<double> first_m, second_m;
};

SharedEdges edges_at_node(const LanesBeside& first, const LanesBeside& second) {
  SharedEdges edges{first.edges_m, second.edges_m};
  const double left_m = std::max(first.edges_m.front(), second.edges_m.front()),
               right_m = std::min(first.edges_m.back(), second.edges_m.back());
  if (second_leads(first, second))
    edges.first_m = led_edges(first, second);
  else
    edges.second_m = led_edges(second, first);
  clamp_edges(left_m, right_m, edges.first_m), clamp_edges(left_m, right_m, edges.second_m);
  return edges;
}

// The edges of all lanes of a road, raised ones beside the carriageway included, as seen along the way.
std::vector<double> all_edges(const Road& road, std::vector<double> carriageway_m, bool is_against) {
  if (is_against) {
    std::ranges::reverse(carriageway_m);
    for (double& edge_m : carriageway_m) edge_m = -edge_m;
  }
  std::vector<double> edges_m = {carriageway_m.front() + raised_left_m(road)};
  std::size_t next = 1;
  for (const Lane& lane : road.section.lanes)
    edges_m.push_back(lane.is_raised ? edges_m.back() - lane.width_m : carriageway_m[next++]);
  return edges_m;
}

LaneChange change_of(const Road& road, const Arm& arm, double cut_m, std::vector<double> offsets_m) {
  const double node_m = distances_along(road)[arm.vertex];
  return {node_m, node_m + arm.step * cut_m, std::move(offsets_m)};
}

}  // namespace

double LaneChange::share_at(double along_m) const {
  assert(node_m != cut_m);
  const double share = (along_m - cut_m) / (node_m - cut_m);
  return share < 0 || share > 1 ? 0 : share;
}

bool is_lane_change(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms) {
  if (junction.family != Family::kStreet || junction.nodes.size() != 1 || arms.size() != 2) return false;
  if (junction.cuts.size() != 2 || disk_radius_m(roads, arms) > 0) return false;
  for (std::size_t a = 0; a < 2; ++a)
    if (junction.cuts[a].length_m <= 0 || junction.cuts[a].length_m == kWholeLink_m) return false;
  return is_taper(junction.family, arm_lines(roads, arms));
}

std::vector<std::vector<LaneChange>> lane_changes_of(std::span<const Road> roads, std::span<const Junction> junctions) {
  std::vector<std::vector<LaneChange>> changes(roads.size());
  const std::vector<std::vector<Arm>> arms = arms_of(junctions, roads);
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    if (!is_lane_change(junctions[j], roads, arms[j])) continue;
    const Arm &first = arms[j][0], &second = arms[j][1];
    const SharedEdges edges = edges_at_node(lanes_beside(roads, first, true), lanes_beside(roads, second, false));
    for (const bool is_first : {true, false}) {
      const Arm& arm = is_first ? first : second;
      const Road& road = roads[arm.road];
      const double cut_m = junctions[j].cuts[is_first ? 0 : 1].length_m;
      changes[arm.road].push_back(change_of(
          road, arm, cut_m, all_edges(road, is_first ? edges.first_m : edges.second_m, runs_against(arm, is_first))));
    }
  }
  return changes;
}

}  // namespace citykiln::roads

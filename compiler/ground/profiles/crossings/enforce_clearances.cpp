#include "compiler/ground/profiles/crossings/enforce_clearances.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/graph/graph_rules.h"
#include "compiler/ground/profiles/graph/graph_walk.h"
#include "compiler/ground/profiles/graph/lowering_caps.h"
#include "compiler/ground/profiles/graph/ramp_shape.h"
#include "compiler/ground/profiles/graph/rigid_units.h"

namespace citykiln::ground {
namespace {

using map::Passage;

/// A ramp loses at least this against the heights given, where these are steeper than any ramp: so it ends.
constexpr double kLeastFade = 0.01;

/// Which upper lines rise: bridges, or also roads and paths over tunnels that could not fall.
enum class Upper { kBridges, kAll };

// A place of a way that should rise, or fall.
struct UnitPush {
  std::uint32_t way = 0;
  double at_m = 0, by_m = 0;
};

struct Enforcer {
  const ProfileGraph& graph;
  std::span<const Crossing> crossings;
  std::vector<double> z_m, start_m;
  RigidUnits units;
  // working memory of spread()
  std::vector<double> unit_cost_m = {};
  std::vector<std::uint32_t> touched = {};
  std::vector<std::pair<double, std::uint32_t>> queue = {};
  std::vector<double> highest_m = {};  // by pinned nodes, which stay
  LoweringCaps lowering = {};
  std::vector<bool> of_graded = {};  // by unit

  Passage passage_of(std::uint32_t way) const {
    return way == kNone ? Passage::kGround : graph.ways[way].track->passage;
  }
  // Paths are planned after roads: nothing on the ground moves for their bridges and tunnels.
  bool is_decided(std::uint32_t way) const {
    return graph.lines == Lines::kPaths || (way != kNone && has_profile(graph.ways[way].track->surface));
  }
  bool rises(const Crossing& c, Upper upper) const;
  bool falls(const Crossing& c) const;
  double move_m(const Crossing& c, std::uint32_t way, double at_m, int up) const;
  double cost_m(const Leg& leg, std::uint32_t from) const;
  void reach(std::uint32_t unit, double cost_there_m);
  void spread(const UnitPush& push, std::vector<double>& up_m);
  double room_m(std::uint32_t unit, std::span<const double> cap_m) const;
  void hold_back(std::span<const double> cap_m, std::vector<double>& by_m);
  bool push_up(std::span<const UnitPush> pushes, std::span<const double> cap_m);
  bool raise(Upper upper);
  bool lower();
};

bool Enforcer::rises(const Crossing& c, Upper upper) const {
  if (c.upper == kNone) return false;
  if (passage_of(c.upper) == Passage::kBridge) return true;
  return upper == Upper::kAll && (graph.lines == Lines::kPaths || is_decided(c.lower));
}

// Tunnels fall, and roads below bridges.
bool Enforcer::falls(const Crossing& c) const {
  if (c.lower == kNone) return false;
  const Passage passage = passage_of(c.lower);
  if (passage == Passage::kTunnel)
    return graph.lines == Lines::kPaths || has_profile(graph.ways[c.lower].track->surface);
  return passage == Passage::kGround && is_decided(c.upper);
}

// Returns how far a crossing's line should move for it, upwards or downwards (`up` 1 or -1): one on the ground no
// farther than kMaxGroundMove_m in all.
double Enforcer::move_m(const Crossing& c, std::uint32_t way, double at_m, int up) const {
  const double by_m = std::min(clearance_shortfall_m(graph, c, z_m), kMaxEnforced_m);
  if (passage_of(way) != Passage::kGround) return by_m;
  const GraphWay& line = graph.ways[way];
  return std::min(
      by_m, kMaxGroundMove_m - up * (height_along(graph, line, z_m, at_m) - height_along(graph, line, start_m, at_m)));
}

// Returns how much less the leg's end must rise than its beginning. A junction plane moves as a whole.
double Enforcer::cost_m(const Leg& leg, std::uint32_t from) const {
  if (units.of[leg.to] == units.of[from]) return 0;
  const double most_m = limit_of(graph, leg) * leg.length_m, drop_m = z_m[from] - z_m[leg.to];
  const double to_steepest_m = (1 + kRampFade) * most_m - drop_m;
  return std::max({most_m - drop_m, std::min(to_steepest_m, kRampFade * most_m), kLeastFade * leg.length_m});
}

// Spreads a push from its place outwards (Dijkstra 1959 on units), each unit keeping the greatest; that of a path not
// to graded lines. One by which its place moves already needs no walk.
void Enforcer::spread(const UnitPush& push, std::vector<double>& up_m) {
  const auto starts = starts_about(graph, push.way, push.at_m);
  if (std::ranges::all_of(starts, [&](const auto& start) { return up_m[units.of[start.second]] >= push.by_m; })) return;
  const bool is_path = !has_profile(graph.ways[push.way].track->surface);
  for (const auto& start : starts) reach(units.of[start.second], 0);
  while (!queue.empty()) {
    std::ranges::pop_heap(queue, std::greater<>());
    const auto [cost_here_m, unit] = queue.back();
    queue.pop_back();
    if (cost_here_m > unit_cost_m[unit] || (is_path && of_graded[unit])) continue;
    up_m[unit] = std::max(up_m[unit], push.by_m - drop_m(cost_here_m));
    for (const std::uint32_t n : units.members(unit)) {
      for (const Leg& leg : graph.legs_of(n)) {
        const double next_m = cost_here_m + cost_m(leg, n);
        if (next_m <= push.by_m + kCrest_m / 2 + kFoot_m) reach(units.of[leg.to], next_m);
      }
    }
  }
  for (const std::uint32_t unit : touched) unit_cost_m[unit] = kFar_m;
  touched.clear();
}

void Enforcer::reach(std::uint32_t unit, double cost_there_m) {
  if (cost_there_m >= unit_cost_m[unit]) return;
  unit_cost_m[unit] = cost_there_m;
  touched.push_back(unit);
  queue.emplace_back(cost_there_m, unit);
  std::ranges::push_heap(queue, std::greater<>());
}

// Returns how far the caps of its nodes let a unit rise; 0 where it is above them.
double Enforcer::room_m(std::uint32_t unit, std::span<const double> cap_m) const {
  double least_m = kFar_m;
  for (const std::uint32_t n : units.members(unit))
    least_m = std::min({least_m, cap_m[n] - z_m[n], start_m[n] + kMaxEnforced_m - z_m[n]});
  return std::max(least_m, 0.0);
}

// Limits the rise of units to their room. A unit that cannot rise holds back its neighbours (Dijkstra 1959), so that no
// line to it becomes steeper than its limit.
void Enforcer::hold_back(std::span<const double> cap_m, std::vector<double>& by_m) {
  const auto hold = [&](std::uint32_t unit, double most_m) {
    if (most_m >= by_m[unit]) return;
    by_m[unit] = most_m;
    queue.emplace_back(most_m, unit);
    std::ranges::push_heap(queue, std::greater<>());
  };
  for (std::uint32_t u = 0; u < units.count(); ++u)
    if (by_m[u] > 0) hold(u, room_m(u, cap_m));
  while (!queue.empty()) {
    std::ranges::pop_heap(queue, std::greater<>());
    const auto [here_m, unit] = queue.back();
    queue.pop_back();
    if (here_m > by_m[unit]) continue;
    for (const std::uint32_t n : units.members(unit))
      for (const Leg& leg : graph.legs_of(n)) {
        const double slack_m = limit_of(graph, leg) * leg.length_m - (z_m[leg.to] - z_m[n]);
        if (units.of[leg.to] != unit) hold(units.of[leg.to], here_m + std::max(slack_m, 0.0));
      }
  }
}

// Moves units up by what they are pushed, below the caps of pinned nodes; returns whether any moved.
bool Enforcer::push_up(std::span<const UnitPush> pushes, std::span<const double> cap_m) {
  if (pushes.empty()) return false;
  std::vector<double> up_m(units.count(), -kFar_m);
  for (const UnitPush& push : pushes) spread(push, up_m);
  for (double& by_m : up_m) by_m = by_m > -kFoot_m ? soft_max(0, by_m) : 0;
  hold_back(cap_m, up_m);
  bool has_moved = false;
  for (std::uint32_t u = 0; u < units.count(); ++u) {
    if (up_m[u] <= 0) continue;
    for (const std::uint32_t n : units.members(u)) z_m[n] += up_m[u];
    has_moved = true;
  }
  return has_moved;
}

bool Enforcer::raise(Upper upper) {
  std::vector<UnitPush> pushes;
  for (const Crossing& c : crossings) {
    if (!rises(c, upper)) continue;
    const double by_m = move_m(c, c.upper, c.upper_at_m, 1);
    if (by_m > kMinShortfall_m) pushes.push_back({c.upper, c.upper_at_m, by_m});
  }
  return push_up(pushes, highest_m);
}

bool Enforcer::lower() {
  std::vector<UnitPush> of_access, of_others;
  for (const Crossing& c : crossings) {
    if (!falls(c)) continue;
    const double by_m = move_m(c, c.lower, c.lower_at_m, -1);
    if (by_m > kMinShortfall_m)
      (is_access_road(graph.ways[c.lower].track->surface) ? of_access : of_others)
          .push_back({c.lower, c.lower_at_m, by_m});
  }
  z_m = negated(z_m), start_m = negated(start_m);
  const bool have_others = push_up(of_others, lowering.of_others), has_access = push_up(of_access, lowering.of_access);
  z_m = negated(z_m), start_m = negated(start_m);
  return have_others || has_access;
}

}  // namespace

std::vector<double> enforce_clearances(const ProfileGraph& graph, std::span<const Crossing> crossings,
                                       std::span<const double> ground_m, std::span<const double> z_m) {
  assert(z_m.size() == graph.nodes.size() && ground_m.size() == graph.nodes.size());
  Enforcer enforcer{graph, crossings, {z_m.begin(), z_m.end()}, {z_m.begin(), z_m.end()}, RigidUnits(graph)};
  enforcer.unit_cost_m.assign(enforcer.units.count(), kFar_m);
  enforcer.of_graded.resize(enforcer.units.count());
  const std::vector<bool> nodes = nodes_of_graded(graph);
  for (std::uint32_t n = 0; n < nodes.size(); ++n)
    if (nodes[n]) enforcer.of_graded[enforcer.units.of[n]] = true;
  GraphWalk walk(graph);
  enforcer.highest_m = caps_near_pinned(graph, walk, z_m);
  enforcer.lowering = lowering_caps(graph, walk, ground_m);
  const auto repeat = [](auto step) {
    for (int round = 0; round < kEnforceRounds && step(); ++round) {
    }
  };
  // directions one after the other: a bridge and a tunnel that are connected would pull each other apart for ever
  for (const Upper upper : {Upper::kBridges, Upper::kBridges, Upper::kAll}) {
    repeat([&] { return enforcer.raise(upper); });
    repeat([&] { return enforcer.lower(); });
  }
  return std::move(enforcer.z_m);
}

}  // namespace citykiln::ground

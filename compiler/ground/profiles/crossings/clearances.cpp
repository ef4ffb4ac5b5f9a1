#include "compiler/ground/profiles/crossings/clearances.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/ground/profiles/crossings/lower_mouths.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/graph/graph_rules.h"
#include "compiler/ground/profiles/graph/graph_walk.h"
#include "compiler/ground/profiles/graph/lowering_caps.h"
#include "compiler/ground/profiles/graph/ramp_shape.h"
#include "compiler/ground/profiles/smoothing/initial_heights.h"

namespace citykiln::ground {
namespace {

using map::Passage;

/// A crossing that was cleared and lost up to this to a neighbour is cleared once more.
constexpr double kMaxSecondLift_m = 2;

// The lines that move, in this order: tunnels below other lines than bridges, bridges, tunnels below bridges that could
// not rise, paths.
enum class Mover { kTunnels, kBridges, kTunnelsUnderBridges, kPaths };

// A place of a way that must rise.
struct RampPush {
  std::uint32_t way = 0;
  double at_m = 0, shortfall_m = 0, half_width_m = 0;
};

struct Clearer {
  const ProfileGraph& graph;
  std::span<const Crossing> crossings;
  std::vector<double> z_m, start_m;
  GraphWalk walk;
  std::vector<double> raising_cap_m = {};  // by pinned nodes
  LoweringCaps lowering = {};
  std::vector<bool> is_above = {};   // by way: whether it is the upper one of some crossing
  std::vector<bool> of_graded = {};  // by node

  // Lines that are not in the graph do not move, like the ground.
  Passage passage_of(std::uint32_t way) const {
    return way == kNone ? Passage::kGround : graph.ways[way].track->passage;
  }
  bool is_tunnel(const Leg& leg) const { return passage_of(leg.way) == Passage::kTunnel; }
  double ramp_m(const Leg& leg) const { return kRampShare * limit_of(graph, leg) * leg.length_m; }

  std::vector<double> floors();
  std::vector<double> covers(const map::Heightfield& heights) const;
  void sink(std::span<const double> floor_m, std::span<const double> cover_m);
  void push_up(std::span<const RampPush> pushes, std::span<const double> cap_m);
  void push_down(const std::vector<RampPush>& pushes);
  std::vector<int> storeys(Mover mover) const;
  bool moves(const Crossing& c, Mover mover) const;
  void make_room(Mover mover);
  void turn_over() { z_m = negated(z_m), start_m = negated(start_m); }
  void keep_near_start();
};

// Returns the lowest heights that tunnels can reach from their mouths at the ramps' grade.
std::vector<double> Clearer::floors() {
  std::vector<double> floor_m(graph.nodes.size(), -kFar_m);
  const auto in_tunnel = [&](const Leg& leg) { return is_tunnel(leg); };
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
    const std::span<const Leg> legs = graph.legs_of(n);
    if (std::ranges::none_of(legs, in_tunnel)) continue;
    const bool is_kept = graph.nodes[n].is_pinned && !graph.nodes[n].is_free_end;
    if (!is_kept && std::ranges::all_of(legs, in_tunnel)) continue;
    walk.from(
        n, kMaxTotalLift_m, [&](const Leg& leg) { return is_tunnel(leg) ? ramp_m(leg) : kFar_m; },
        [&](std::uint32_t node, double cost_m) {
          floor_m[node] = std::max(floor_m[node], z_m[n] - drop_m(cost_m));
          return true;
        });
  }
  return floor_m;
}

// Returns the greatest heights at which tunnels are covered by the ground.
std::vector<double> Clearer::covers(const map::Heightfield& heights) const {
  std::vector<double> cover_m(graph.nodes.size(), kFar_m);
  for (const GraphWay& way : graph.ways) {
    const map::Track& track = *way.track;
    if (track.passage != Passage::kTunnel || !needs_cover(track)) continue;
    const bool is_path = map::values_of(track.surface).group == map::LandCoverGroup::kPath;
    for (const Station& station : graph.stations_of(way)) {
      const double ground_m = filtered_height_m(heights, graph.nodes[station.node].at);
      cover_m[station.node] =
          std::min(cover_m[station.node], ground_m - (is_path ? kPathTunnelCover_m : kTunnelCover_m));
    }
  }
  return cover_m;
}

// Lowers tunnels between their mouths, not below their floors.
void Clearer::sink(std::span<const double> floor_m, std::span<const double> cover_m) {
  std::vector<double> down_m(z_m.size(), kFar_m);
  const auto press = [&](std::span<const GraphWalk::Start> starts, double at_m) {
    walk.from(
        starts, kMaxTotalLift_m, [&](const Leg& leg) { return is_tunnel(leg) ? ramp_m(leg) : kFar_m; },
        [&](std::uint32_t node, double cost_m) {
          down_m[node] = std::min(down_m[node], at_m + drop_m(cost_m));
          return at_m + drop_m(cost_m) < z_m[node] + kFoot_m;
        });
  };
  for (const Crossing& c : crossings) {
    if (passage_of(c.lower) != Passage::kTunnel) continue;
    const double shortfall_m = std::min(clearance_shortfall_m(graph, c, z_m), kMaxLift_m);
    if (shortfall_m > kMinShortfall_m)
      press(starts_about(graph, c.lower, c.lower_at_m),
            height_along(graph, graph.ways[c.lower], z_m, c.lower_at_m) - shortfall_m);
  }
  for (std::uint32_t n = 0; n < cover_m.size(); ++n) {
    if (cover_m[n] >= z_m[n]) continue;
    const GraphWalk::Start start{0, n};
    press(std::span(&start, 1), std::max(cover_m[n], z_m[n] - kMaxLift_m));
  }
  for (std::uint32_t n = 0; n < z_m.size(); ++n)
    if (down_m[n] < z_m[n] + kFoot_m) z_m[n] = std::max(-soft_max(-z_m[n], -down_m[n]), std::min(floor_m[n], z_m[n]));
}

// Raises everything connected to the places by ramps, for a path nothing but paths. On a slope a ramp is as steep as
// allowed, or, where it has risen less than the slope, falls towards it at half its grade, so that it terminates.
void Clearer::push_up(std::span<const RampPush> pushes, std::span<const double> cap_m) {
  std::vector<double> up_m(z_m.size(), -kFar_m);
  for (const RampPush& push : pushes) {
    const GraphWay& way = graph.ways[push.way];
    const double top_m = height_along(graph, way, z_m, push.at_m) + push.shortfall_m;
    const double rise_m = top_m - height_along(graph, way, start_m, push.at_m);
    const double level_m = ramp_m({0, push.way, push.half_width_m});
    const bool is_path = !has_profile(way.track->surface);
    walk.from(
        starts_about(graph, push.way, push.at_m), 5 * std::max(rise_m, 0.0) + kCrest_m + level_m,
        [&](const Leg& leg) { return ramp_m(leg); },
        [&](std::uint32_t node, double cost_m) {
          if (is_path && of_graded[node]) return false;
          const double down_m = drop_m(cost_m - level_m);
          const double steep_m = top_m - down_m / kRampShare - std::max(0.0, down_m - 2 * rise_m) / 2;
          const double faded_m = start_m[node] + rise_m - down_m / 2;
          const double here_m = std::min(top_m - down_m, std::max(steep_m, faded_m));
          up_m[node] = std::max(up_m[node], here_m);
          return here_m > z_m[node] - kFoot_m;
        });
  }
  for (std::uint32_t n = 0; n < z_m.size(); ++n)
    if (up_m[n] > z_m[n] - kFoot_m) z_m[n] = std::min(soft_max(z_m[n], up_m[n]), std::max(z_m[n], cap_m[n]));
}

void Clearer::push_down(const std::vector<RampPush>& pushes) {
  std::vector<RampPush> of_access, of_others;
  for (const RampPush& push : pushes)
    (is_access_road(graph.ways[push.way].track->surface) ? of_access : of_others).push_back(push);
  turn_over();
  push_up(of_others, lowering.of_others);
  push_up(of_access, lowering.of_access);
  turn_over();
}

// Tunnels move with their approaches; paths on the ground move unless they pass over something.
bool Clearer::moves(const Crossing& c, Mover mover) const {
  if (mover == Mover::kBridges) return passage_of(c.upper) == Passage::kBridge;
  if (c.lower == kNone) return false;
  if (mover == Mover::kPaths)
    return graph.lines == Lines::kPaths && passage_of(c.lower) == Passage::kGround && !is_above[c.lower];
  if (passage_of(c.lower) != Passage::kTunnel) return false;
  if ((mover == Mover::kTunnelsUnderBridges) != (passage_of(c.upper) == Passage::kBridge)) return false;
  // no street is lowered with an underpass that ends on it
  return graph.lines == Lines::kPaths || has_profile(graph.ways[c.lower].track->surface);
}

// Returns per crossing its storey: how many moving crossings are stacked below it (above it, for tunnels), with itself.
std::vector<int> Clearer::storeys(Mover mover) const {
  std::vector<int> of_way(graph.ways.size(), 0), of_crossing(crossings.size(), 0);
  for (int round = 0; round < kLiftRounds; ++round) {
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const Crossing& c = crossings[i];
      if (!moves(c, mover)) continue;
      const std::uint32_t still = mover == Mover::kBridges ? c.lower : c.upper;
      of_crossing[i] = 1 + (still == kNone ? 0 : of_way[still]);
    }
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      if (of_crossing[i] == 0) continue;
      int& storey = of_way[mover == Mover::kBridges ? crossings[i].upper : crossings[i].lower];
      storey = std::max(storey, of_crossing[i]);
    }
  }
  return of_crossing;
}

// Clears storey by storey, each crossing once: two connected lines that raise each other would rise for ever.
void Clearer::make_room(Mover mover) {
  const std::vector<int> storey = storeys(mover);
  const bool lifts = mover == Mover::kBridges;
  for (int round = 1; round <= kLiftRounds + 1; ++round) {
    const bool is_last = round > kLiftRounds;
    std::vector<RampPush> pushes;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      const Crossing& c = crossings[i];
      if (storey[i] == 0 || (!is_last && storey[i] != round)) continue;
      const double most_m =
          mover == Mover::kPaths ? kMaxPathLowering_m : kMaxLift_m + (storey[i] - 1) * kClearanceOverRail_m;
      const double shortfall_m = std::min(clearance_shortfall_m(graph, c, z_m), most_m);
      if (shortfall_m <= kMinShortfall_m || (is_last && shortfall_m > kMaxSecondLift_m)) continue;
      pushes.push_back(lifts ? RampPush{c.upper, c.upper_at_m, shortfall_m, c.half_width_m}
                             : RampPush{c.lower, c.lower_at_m, shortfall_m, c.half_width_m});
    }
    if (pushes.empty()) continue;
    lifts ? push_up(pushes, raising_cap_m) : push_down(pushes);
  }
}

void Clearer::keep_near_start() {
  for (std::size_t n = 0; n < z_m.size(); ++n)
    z_m[n] = std::clamp(z_m[n], start_m[n] - kMaxTotalLift_m, start_m[n] + kMaxTotalLift_m);
}

}  // namespace

std::vector<double> clear_crossings(const ProfileGraph& graph, std::span<const Crossing> crossings,
                                    const map::Heightfield* heights, std::span<const double> z_m) {
  assert(z_m.size() == graph.nodes.size());
  Clearer clearer{graph, crossings, {z_m.begin(), z_m.end()}, {z_m.begin(), z_m.end()}, GraphWalk(graph)};
  clearer.raising_cap_m = caps_near_pinned(graph, clearer.walk, z_m);
  clearer.lowering = lowering_caps(graph, clearer.walk, z_m);
  clearer.of_graded = nodes_of_graded(graph);
  clearer.is_above.resize(graph.ways.size());
  for (const Crossing& c : crossings)
    if (c.upper != kNone) clearer.is_above[c.upper] = true;
  const std::vector<double> floor_m = clearer.floors();
  if (heights != nullptr) clearer.sink(floor_m, clearer.covers(*heights));
  for (int round = 1; round < kLiftRounds; ++round) clearer.sink(floor_m, {});
  for (const Mover mover : {Mover::kTunnels, Mover::kBridges, Mover::kTunnelsUnderBridges, Mover::kPaths})
    clearer.make_room(mover);
  // foot bridges may have been lowered with a path
  if (graph.lines == Lines::kPaths) clearer.make_room(Mover::kBridges);
  clearer.keep_near_start();
  return std::move(clearer.z_m);
}

}  // namespace citykiln::ground

#include "compiler/ground/profiles/graph/lowering_caps.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "compiler/ground/profiles/graph/graph_rules.h"

namespace citykiln::ground {
namespace {

bool is_on_street(const ProfileGraph& graph, std::uint32_t node) {
  return std::ranges::any_of(graph.legs_of(node), [&](const Leg& leg) {
    const map::Track& track = *graph.ways[leg.way].track;
    return track.passage == map::Passage::kGround && !is_access_road(track.surface);
  });
}

// Returns by node the greatest height that ground nodes allow, each `most_m(node)` above its own, and lines for which
// `reaches(track)` holds as far above as their grade limits, up to kPinRadius_m. Heights have their signs changed.
template <typename Most, typename Reaches>
std::vector<double> caps_near_ground(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> down_m,
                                     Most most_m, Reaches reaches) {
  const auto cost_of = [&](const Leg& leg) {
    return reaches(*graph.ways[leg.way].track) ? limit_of(graph, leg) * leg.length_m
                                               : std::numeric_limits<double>::infinity();
  };
  std::vector<double> cap_m(down_m.size(), std::numeric_limits<double>::infinity());
  for (std::uint32_t n = 0; n < down_m.size(); ++n) {
    if (!graph.nodes[n].is_on_ground) continue;
    const double own_m = down_m[n] + most_m(n);
    walk.from(n, kPinRadius_m, cost_of, [&](std::uint32_t node, double up_m) {
      cap_m[node] = std::min(cap_m[node], own_m + up_m);
      return true;
    });
  }
  return cap_m;
}

void lower_to(std::vector<double>& cap_m, std::span<const double> other_m) {
  for (std::size_t n = 0; n < cap_m.size(); ++n) cap_m[n] = std::min(cap_m[n], other_m[n]);
}

}  // namespace

std::vector<double> caps_near_pinned(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> z_m) {
  assert(z_m.size() == graph.nodes.size());
  std::vector<double> cap_m(z_m.size(), std::numeric_limits<double>::infinity());
  for (std::uint32_t n = 0; n < z_m.size(); ++n) {
    // an end that meets nothing may leave the ground
    if (!graph.nodes[n].is_pinned || graph.nodes[n].is_free_end) continue;
    walk.from(
        n, kPinRadius_m, [&](const Leg& leg) { return limit_of(graph, leg) * leg.length_m; },
        [&](std::uint32_t node, double up_m) {
          cap_m[node] = std::min(cap_m[node], z_m[n] + up_m);
          return true;
        });
  }
  return cap_m;
}

bool is_access_road(map::LandCoverClass surface) {
  using map::LandCoverClass;
  return surface == LandCoverClass::kServiceRoad || surface == LandCoverClass::kFarmTrack ||
         surface == LandCoverClass::kUnpavedRoad;
}

LoweringCaps lowering_caps(const ProfileGraph& graph, GraphWalk& walk, std::span<const double> ground_m) {
  const std::vector<double> down_m = negated(ground_m), near_pinned_m = caps_near_pinned(graph, walk, down_m);
  const auto is_tunnel = [](const map::Track& track) { return track.passage == map::Passage::kTunnel; };
  LoweringCaps caps;
  caps.of_others = caps_near_ground(
      graph, walk, down_m, [](std::uint32_t) { return kMaxCutting_m; }, is_tunnel);
  caps.of_access = caps_near_ground(
      graph, walk, down_m,
      [&](std::uint32_t n) { return is_on_street(graph, n) ? kMaxCuttingForAccess_m : kMaxCutting_m; },
      [&](const map::Track& track) { return is_tunnel(track) || is_access_road(track.surface); });
  lower_to(caps.of_others, near_pinned_m), lower_to(caps.of_access, near_pinned_m);
  return caps;
}

}  // namespace citykiln::ground

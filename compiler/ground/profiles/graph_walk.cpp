#include "compiler/ground/profiles/graph_walk.h"

#include <cassert>

#include "compiler/ground/profiles/grade_rules.h"

namespace citykiln::ground {

std::vector<GraphWalk::Start> starts_about(const ProfileGraph& graph, std::uint32_t way, double at_m) {
  assert(way < graph.ways.size());
  const std::uint32_t i = graph.ways[way].first + station_before(graph, graph.ways[way], at_m);
  return {{0, graph.stations[i].node}, {0, graph.stations[i + 1].node}};
}

double limit_of(const ProfileGraph& graph, const Leg& leg) {
  return graph.limit_scale * grade_rule_of(graph.ways[leg.way].track->surface).limit;
}

bool may_be_steeper(const ProfileGraph& graph, std::uint32_t way) {
  const map::LandCoverClass surface = graph.ways[way].track->surface;
  return map::values_of(surface).group != map::LandCoverGroup::kRail && surface != map::LandCoverClass::kMotorwayRoad &&
         surface != map::LandCoverClass::kRunway;
}

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

}  // namespace citykiln::ground

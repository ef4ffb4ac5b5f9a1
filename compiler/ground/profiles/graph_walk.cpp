#include "compiler/ground/profiles/graph_walk.h"

#include "compiler/ground/profiles/grade_rules.h"

namespace citykiln::ground {

std::vector<GraphWalk::Start> starts_about(const ProfileGraph& graph, std::uint32_t way, double at_m) {
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

}  // namespace citykiln::ground

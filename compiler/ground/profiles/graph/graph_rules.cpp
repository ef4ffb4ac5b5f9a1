#include "compiler/ground/profiles/graph/graph_rules.h"

#include "compiler/ground/profiles/graph/grade_rules.h"

namespace citykiln::ground {

std::vector<bool> nodes_of_graded(const ProfileGraph& graph) {
  std::vector<bool> nodes(graph.nodes.size());
  for (const GraphWay& way : graph.ways)
    for (const Station& station : graph.stations_of(way))
      if (has_profile(way.track->surface)) nodes[station.node] = true;
  return nodes;
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

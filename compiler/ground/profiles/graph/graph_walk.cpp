#include "compiler/ground/profiles/graph/graph_walk.h"

#include <cassert>

namespace citykiln::ground {

std::vector<GraphWalk::Start> starts_about(const ProfileGraph& graph, std::uint32_t way, double at_m) {
  assert(way < graph.ways.size());
  const std::uint32_t i = graph.ways[way].first + station_before(graph, graph.ways[way], at_m);
  return {{0, graph.stations[i].node}, {0, graph.stations[i + 1].node}};
}

}  // namespace citykiln::ground

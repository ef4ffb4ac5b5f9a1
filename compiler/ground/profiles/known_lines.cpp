#include "compiler/ground/profiles/known_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/ground/profiles/graph/graph_walk.h"

namespace citykiln::ground {
namespace {

bool leads_into_tunnel(const ProfileGraph& graph, std::uint32_t node) {
  return std::ranges::any_of(
      graph.legs_of(node), [&](const Leg& leg) { return graph.ways[leg.way].track->passage == map::Passage::kTunnel; });
}

// By node: true on the land.
std::vector<bool> nodes_on_land(const ProfileGraph& graph) {
  std::vector<bool> is_on_land(graph.nodes.size());
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) is_on_land[n] = graph.nodes[n].is_on_ground;
  GraphWalk walk(graph);
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
    if (!graph.nodes[n].is_on_ground || !leads_into_tunnel(graph, n)) continue;
    walk.from(
        n, kPortalCutting_m, [](const Leg& leg) { return leg.length_m; },
        [&](std::uint32_t node, double) {
          is_on_land[node] = false;
          return true;
        });
  }
  return is_on_land;
}

bool gives_heights(const GraphWay& way) { return way.road != kNone && !way.track->is_in_earthwork; }

}  // namespace

std::vector<KnownLine> known_lines(const ProfileGraph& graph, std::span<const double> ground_m,
                                   std::span<const double> z_m, const map::Heightfield& heights,
                                   const LandformIndex& landforms) {
  assert(ground_m.size() == graph.nodes.size() && z_m.size() == graph.nodes.size());
  const std::vector<bool> is_on_land = nodes_on_land(graph);
  const auto height_m = [&](std::uint32_t node) {
    const double terrain_m = map::height_m_at(heights, graph.nodes[node].at);
    const bool is_ramp = std::abs(z_m[node] - ground_m[node]) > kLeastRamp_m;
    return (is_ramp ? ground_m : z_m)[node] -
           (with_landforms_m(landforms, graph.nodes[node].at, terrain_m) - terrain_m);
  };
  std::vector<KnownLine> lines;
  for (const GraphWay& way : graph.ways) {
    if (!gives_heights(way)) continue;
    const bool is_level = way.track->surface == map::LandCoverClass::kRunway;
    const std::span<const Station> stations = graph.stations_of(way);
    for (std::size_t s = 0; s + 1 < stations.size(); ++s) {
      const std::uint32_t from = stations[s].node, to = stations[s + 1].node;
      if (!is_on_land[from] || !is_on_land[to]) continue;
      lines.push_back({graph.nodes[from].at, graph.nodes[to].at, height_m(from), height_m(to),
                       is_level ? KnownKind::kLevel : KnownKind::kRoad});
    }
  }
  return lines;
}

}  // namespace citykiln::ground

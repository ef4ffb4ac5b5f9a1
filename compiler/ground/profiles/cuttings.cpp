#include "compiler/ground/profiles/cuttings.h"

#include <cassert>
#include <cmath>

#include "compiler/ground/grading/road_influence.h"

namespace citykiln::ground {
namespace {

bool is_of_tunnel(const ProfileGraph& graph, const Leg& leg) {
  return graph.ways[leg.way].track->passage == map::Passage::kTunnel;
}

// By node: true below the land, where lines on the ground lead to a mouth without coming up.
std::vector<bool> nodes_in_cuttings(const ProfileGraph& graph, std::span<const double> ground_m,
                                    std::span<const double> z_m) {
  std::vector<bool> is_in_cutting(graph.nodes.size());
  std::vector<std::uint32_t> open;
  const auto enter = [&](std::uint32_t n) {
    if (is_in_cutting[n] || !graph.nodes[n].is_on_ground || ground_m[n] - z_m[n] <= kLeastCutting_m) return;
    is_in_cutting[n] = true;
    open.push_back(n);
  };
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n)
    for (const Leg& leg : graph.legs_of(n))
      if (is_of_tunnel(graph, leg)) enter(n);
  while (!open.empty()) {
    const std::uint32_t n = open.back();
    open.pop_back();
    for (const Leg& leg : graph.legs_of(n))
      if (graph.ways[leg.way].road != kNone) enter(leg.to);
  }
  return is_in_cutting;
}

double quarters(double at_m) { return std::round(at_m * 4) / 4; }

std::vector<roads::Cutting> cuttings_along(std::span<const Station> stations, const std::vector<bool>& is_in_cutting) {
  std::vector<roads::Cutting> cuttings;
  const std::size_t last = stations.size() - 1;
  for (std::size_t s = 0; s <= last; ++s) {
    if (!is_in_cutting[stations[s].node]) continue;
    const std::size_t first = s;
    while (s < last && is_in_cutting[stations[s + 1].node]) ++s;
    const double from_m = first == 0 ? 0 : quarters(stations[first - 1].at_m);
    const double to_m = s == last ? quarters(stations[last].at_m) + kCuttingEnd_m : quarters(stations[s + 1].at_m);
    if (!cuttings.empty() && cuttings.back().to_m >= from_m)
      cuttings.back().to_m = to_m;
    else
      cuttings.push_back({from_m, to_m});
  }
  return cuttings;
}

}  // namespace

std::vector<std::vector<roads::Cutting>> cuttings_of(const ProfileGraph& graph, std::span<const double> ground_m,
                                                     std::span<const double> z_m) {
  assert(ground_m.size() == graph.nodes.size() && z_m.size() == graph.nodes.size());
  const std::vector<bool> is_in_cutting = nodes_in_cuttings(graph, ground_m, z_m);
  std::vector<std::vector<roads::Cutting>> cuttings(graph.ways.size());
  for (std::size_t w = 0; w < graph.ways.size(); ++w)
    if (graph.ways[w].road != kNone) cuttings[w] = cuttings_along(graph.stations_of(graph.ways[w]), is_in_cutting);
  return cuttings;
}

}  // namespace citykiln::ground

#include "compiler/structures/deck_graph.h"

#include <algorithm>

#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

using Ids = std::vector<std::int64_t>;

Ids sorted_once(Ids ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

Ids nodes_off_bridges(const map::Features& features) {
  Ids ids;
  for (const map::Track& track : features.tracks)
    if (track.passage != map::Passage::kBridge) ids.insert(ids.end(), track.node_ids.begin(), track.node_ids.end());
  return sorted_once(std::move(ids));
}

Ids nodes_of(const std::vector<const map::Track*>& bridges) {
  Ids ids;
  for (const map::Track* bridge : bridges) ids.insert(ids.end(), bridge->node_ids.begin(), bridge->node_ids.end());
  return sorted_once(std::move(ids));
}

struct GraphBuilder {
  const map::Heightfield& heights;
  Ids node_ids;
  DeckGraph graph;

  std::uint32_t node(std::int64_t id) const {
    return static_cast<std::uint32_t>(std::lower_bound(node_ids.begin(), node_ids.end(), id) - node_ids.begin());
  }

  void stand(std::uint32_t index, Vec2 at, double clearance_m) {
    Station& station = graph.stations[index];
    station.at = at;
    station.ground_m = snapped(height_m_at(heights, at));
    station.clearance_m = std::max(station.clearance_m, clearance_m);
  }

  void join(std::uint32_t a, std::uint32_t b) {
    const double length_m = distance(graph.stations[a].at, graph.stations[b].at);
    graph.stations[a].legs.push_back({b, length_m});
    graph.stations[b].legs.push_back({a, length_m});
  }

  // The segment from the station `from` to `to`, cut into equal pieces.
  void add_segment(std::vector<std::uint32_t>& bridge, std::uint32_t from, std::uint32_t to, double clearance_m) {
    const Vec2 a = graph.stations[from].at, b = graph.stations[to].at;
    const int pieces = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kStation_m)));
    for (int i = 1; i <= pieces; ++i) {
      const auto next = i == pieces ? to : static_cast<std::uint32_t>(graph.stations.size());
      if (i < pieces) {
        graph.stations.emplace_back();
        stand(next, snapped(a + (b - a) * (static_cast<double>(i) / pieces)), clearance_m);
      }
      join(bridge.back(), next);
      bridge.push_back(next);
    }
  }

  void add(const map::Track& track) {
    const double clearance_m = kClearance_m * std::max<int>(track.layer, 1);
    for (std::size_t i = 0; i < track.axis.size(); ++i) stand(node(track.node_ids[i]), track.axis[i], clearance_m);
    std::vector<std::uint32_t>& bridge = graph.bridges.emplace_back(1, node(track.node_ids[0]));
    for (std::size_t i = 1; i < track.axis.size(); ++i)
      add_segment(bridge, node(track.node_ids[i - 1]), node(track.node_ids[i]), clearance_m);
  }
};

void anchor_loose_ends(DeckGraph& graph, const std::vector<const map::Track*>& bridges, Report& report) {
  for (std::size_t i = 0; i < bridges.size(); ++i)
    for (const std::uint32_t end : {graph.bridges[i].front(), graph.bridges[i].back()}) {
      Station& station = graph.stations[end];
      if (station.is_anchored || station.legs.size() > 1) continue;
      station.is_anchored = true;
      report.add(Code::kBridgeWithoutGround, bridges[i]->id.osm);
    }
}

}  // namespace

DeckGraph graph_of(const std::vector<const map::Track*>& bridges, const map::Features& features,
                   const map::Heightfield& heights, Report& report) {
  GraphBuilder builder{heights, nodes_of(bridges), {}};
  builder.graph.stations.resize(builder.node_ids.size());
  for (const map::Track* bridge : bridges) builder.add(*bridge);
  const Ids off_bridges = nodes_off_bridges(features);
  for (std::size_t i = 0; i < builder.node_ids.size(); ++i)
    builder.graph.stations[i].is_anchored =
        std::binary_search(off_bridges.begin(), off_bridges.end(), builder.node_ids[i]);
  anchor_loose_ends(builder.graph, bridges, report);
  return std::move(builder.graph);
}

}  // namespace citykiln::structures

#include "compiler/ground/approach_paths.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "compiler/geometry/snap.h"
#include "compiler/ground/grade_rules.h"

namespace citykiln::ground {
namespace {

using map::Track;

constexpr double kFar_m = std::numeric_limits<double>::infinity();

bool may_lead_up(const Track& track) {
  return track.passage == map::Passage::kGround && !is_graded(track.surface) &&
         map::values_of(track.surface).group == map::SurfaceGroup::kPath && length_m(track.axis) <= kLongestApproach_m;
}

// Nodes of the map on paths, and how far along paths they are from what leaves the ground.
struct Nodes {
  std::vector<std::int64_t> ids;  // sorted
  std::vector<double> run_m;
  // Pieces of paths from node to node, sorted by the first.
  struct Piece {
    std::size_t from, to;
    double length_m;
  };
  std::vector<Piece> pieces;

  std::size_t of(std::int64_t id) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(ids, id) - ids.begin());
  }
  bool has(std::int64_t id) const { return std::ranges::binary_search(ids, id); }
};

Nodes nodes_of(const std::vector<Track>& tracks) {
  Nodes nodes;
  for (const Track& track : tracks)
    if (may_lead_up(track)) nodes.ids.insert(nodes.ids.end(), track.node_ids.begin(), track.node_ids.end());
  std::ranges::sort(nodes.ids);
  nodes.ids.erase(std::unique(nodes.ids.begin(), nodes.ids.end()), nodes.ids.end());
  nodes.run_m.assign(nodes.ids.size(), kFar_m);
  for (const Track& track : tracks) {
    for (std::size_t i = 0; may_lead_up(track) && i + 1 < track.axis.size(); ++i) {
      const std::size_t a = nodes.of(track.node_ids[i]), b = nodes.of(track.node_ids[i + 1]);
      const double run_m = snapped(distance(track.axis[i], track.axis[i + 1]));
      nodes.pieces.push_back({a, b, run_m}), nodes.pieces.push_back({b, a, run_m});
    }
  }
  std::ranges::sort(nodes.pieces, {}, &Nodes::Piece::from);
  return nodes;
}

// Dijkstra (1959), from all at once.
void measure_from(const std::vector<Track>& tracks, Nodes& nodes) {
  std::vector<std::pair<double, std::size_t>> queue;
  const auto reach = [&](std::size_t node, double run_m) {
    if (run_m >= nodes.run_m[node] || run_m > kApproach_m) return;
    nodes.run_m[node] = run_m;
    queue.emplace_back(run_m, node);
    std::ranges::push_heap(queue, std::greater<>());
  };
  for (const Track& track : tracks) {
    if (track.passage == map::Passage::kGround) continue;
    for (const std::int64_t id : track.node_ids)
      if (nodes.has(id)) reach(nodes.of(id), 0);
  }
  while (!queue.empty()) {
    std::ranges::pop_heap(queue, std::greater<>());
    const auto [run_m, node] = queue.back();
    queue.pop_back();
    if (run_m > nodes.run_m[node]) continue;
    auto piece = std::ranges::lower_bound(nodes.pieces, node, {}, &Nodes::Piece::from);
    for (; piece != nodes.pieces.end() && piece->from == node; ++piece) reach(piece->to, run_m + piece->length_m);
  }
}

}  // namespace

std::vector<bool> approach_paths(const map::Features& features) {
  Nodes nodes = nodes_of(features.tracks);
  measure_from(features.tracks, nodes);
  std::vector<bool> leads_up;
  for (const Track& track : features.tracks)
    leads_up.push_back(may_lead_up(track) && std::ranges::any_of(track.node_ids, [&](std::int64_t id) {
                         return nodes.run_m[nodes.of(id)] <= kApproach_m;
                       }));
  return leads_up;
}

}  // namespace citykiln::ground

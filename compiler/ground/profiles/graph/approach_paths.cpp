#include "compiler/ground/profiles/graph/approach_paths.h"

#include <algorithm>
#include <functional>
#include <span>

#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/graph/ramp_shape.h"

namespace citykiln::ground {
namespace {

using map::Track;

bool may_merge(const Track& track) {
  return track.passage == map::Passage::kGround && !has_profile(track.surface) &&
         map::values_of(track.surface).group == map::LandCoverGroup::kPath &&
         length_m(track.axis) <= kLongestApproach_m;
}

// Map nodes on paths, and their distance along paths from the nearest end of a bridge or tunnel.
struct Nodes {
  std::vector<std::int64_t> ids;  // sorted
  std::vector<double> run_m;
  // A piece of path between two nodes; sorted by the first.
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

Nodes nodes_of(std::span<const Track> tracks) {
  Nodes nodes;
  for (const Track& track : tracks)
    if (may_merge(track)) nodes.ids.insert(nodes.ids.end(), track.node_ids.begin(), track.node_ids.end());
  sort_unique(nodes.ids);
  nodes.run_m.assign(nodes.ids.size(), kFar_m);
  for (const Track& track : tracks) {
    for (std::size_t i = 0; may_merge(track) && i + 1 < track.axis.size(); ++i) {
      const std::size_t a = nodes.of(track.node_ids[i]), b = nodes.of(track.node_ids[i + 1]);
      const double run_m = snapped(distance(track.axis[i], track.axis[i + 1]));
      nodes.pieces.push_back({a, b, run_m}), nodes.pieces.push_back({b, a, run_m});
    }
  }
  std::ranges::sort(nodes.pieces, {}, &Nodes::Piece::from);
  return nodes;
}

// Nodes of bridges and tunnels, sorted: ends where no other continues, and all others.
struct OffGround {
  std::vector<std::int64_t> ends, inner;
};

OffGround off_ground_of(std::span<const Track> tracks) {
  std::vector<std::int64_t> off;  // inner nodes of a way occur twice, as it continues there
  for (const Track& track : tracks) {
    if (track.passage == map::Passage::kGround) continue;
    off.insert(off.end(), track.node_ids.begin(), track.node_ids.end());
    off.insert(off.end(), track.node_ids.begin() + 1, track.node_ids.end() - 1);
  }
  std::ranges::sort(off);
  OffGround nodes;
  for (std::size_t i = 0, next = 0; i < off.size(); i = next) {
    while (next < off.size() && off[next] == off[i]) ++next;
    (next - i == 1 ? nodes.ends : nodes.inner).push_back(off[i]);
  }
  return nodes;
}

// Dijkstra (1959) from all ends at once.
void measure_from(std::span<const std::int64_t> ends, Nodes& nodes) {
  std::vector<std::pair<double, std::size_t>> queue;
  const auto reach = [&](std::size_t node, double run_m) {
    if (run_m >= nodes.run_m[node] || run_m > kApproach_m) return;
    nodes.run_m[node] = run_m;
    queue.emplace_back(run_m, node);
    std::ranges::push_heap(queue, std::greater<>());
  };
  for (const std::int64_t id : ends)
    if (nodes.has(id)) reach(nodes.of(id), 0);
  while (!queue.empty()) {
    std::ranges::pop_heap(queue, std::greater<>());
    const auto [run_m, node] = queue.back();
    queue.pop_back();
    if (run_m > nodes.run_m[node]) continue;
    auto piece = std::ranges::lower_bound(nodes.pieces, node, {}, &Nodes::Piece::from);
    for (; piece != nodes.pieces.end() && piece->from == node; ++piece) reach(piece->to, run_m + piece->length_m);
  }
}

// Pieces of the axes of bridges.
struct Decks {
  std::vector<std::pair<Vec2, Vec2>> pieces;
  BoxGrid grid;
};

Decks decks_of(std::span<const Track> tracks) {
  constexpr double kBucket_m = 64;
  Decks decks;
  std::vector<Box2> boxes;
  for (const Track& track : tracks) {
    if (track.passage != map::Passage::kBridge) continue;
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
      decks.pieces.emplace_back(track.axis[i], track.axis[i + 1]);
      boxes.push_back(box_of(std::span(track.axis).subspan(i, 2)));
    }
  }
  decks.grid = grid_of(boxes, kBucket_m);
  return decks;
}

// Touching counts, so it does not matter which of two pieces has a vertex there.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto are_apart = [](double one, double two) { return (one > 0 && two > 0) || (one < 0 && two < 0); };
  return !are_apart(cross(b - a, c - a), cross(b - a, d - a)) && !are_apart(cross(d - c, a - c), cross(d - c, b - c));
}

bool passes_below(const Track& track, const Decks& decks) {
  for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
    const Vec2 a = track.axis[i], b = track.axis[i + 1];
    for (const std::uint32_t piece : boxes_about(decks.grid, box_of(std::span(track.axis).subspan(i, 2))))
      if (cross_each_other(a, b, decks.pieces[piece].first, decks.pieces[piece].second)) return true;
  }
  return false;
}

}  // namespace

std::vector<bool> approach_paths(const map::FeatureView& features) {
  Nodes nodes = nodes_of(features.tracks);
  const OffGround off_ground = off_ground_of(features.tracks);
  measure_from(off_ground.ends, nodes);
  const Decks decks = decks_of(features.tracks);
  const auto is_near = [&](std::int64_t id) { return nodes.run_m[nodes.of(id)] <= kApproach_m; };
  const auto is_inner = [&](std::int64_t id) { return std::ranges::binary_search(off_ground.inner, id); };
  std::vector<bool> yields;
  for (const Track& track : features.tracks)
    yields.push_back(may_merge(track) && std::ranges::none_of(track.node_ids, is_inner) &&
                     (std::ranges::any_of(track.node_ids, is_near) || passes_below(track, decks)));
  return yields;
}

}  // namespace citykiln::ground

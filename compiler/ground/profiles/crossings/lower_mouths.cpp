#include "compiler/ground/profiles/crossings/lower_mouths.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/grading/span_influence.h"
#include "compiler/ground/profiles/crossings/clearances.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/graph/graph_rules.h"
#include "compiler/ground/profiles/graph/graph_walk.h"
#include "compiler/ground/profiles/graph/ramp_shape.h"
#include "compiler/ground/profiles/planned_spans.h"
#include "compiler/map/ways/passageways.h"
#include "compiler/roads/roads_on_ground.h"

namespace citykiln::ground {
namespace {

using map::Passage;

// The mouth of a tunnel, and the height at which the land covers the tunnel.
struct Mouth {
  std::uint32_t node = 0;
  double wanted_m = 0;
};

// A node that a descent reaches, by the cost of the way there: the height that the grade limits allow.
struct Reached {
  std::uint32_t node = 0;
  double cost_m = 0;
};

Passage passage_of(const ProfileGraph& graph, const Leg& leg) { return graph.ways[leg.way].track->passage; }

std::uint32_t legs_on_ground(const ProfileGraph& graph, std::uint32_t node) {
  return static_cast<std::uint32_t>(std::ranges::count_if(
      graph.legs_of(node), [&](const Leg& leg) { return passage_of(graph, leg) == Passage::kGround; }));
}

// Map nodes of ways on the ground that are no part of the graph, sorted.
std::vector<std::int64_t> nodes_beside_graph(const ProfileGraph& graph, const map::FeatureView& features) {
  std::vector<ObjectId> members;
  for (const GraphWay& way : graph.ways) members.push_back(way.track->id);
  std::ranges::sort(members);
  std::vector<std::int64_t> nodes;
  for (const map::Track& track : features.tracks)
    if (!leaves_ground(track) && !std::ranges::binary_search(members, track.id))
      nodes.insert(nodes.end(), track.node_ids.begin(), track.node_ids.end());
  sort_unique(nodes);
  return nodes;
}

// True where a tunnel meets a line on the ground.
bool is_mouth(const ProfileGraph& graph, std::uint32_t node) {
  const std::uint32_t on_ground = legs_on_ground(graph, node);
  return on_ground > 0 && on_ground < graph.nodes[node].legs;
}

// The land's height inside a tunnel, kPortalLength_m from one of its ends, or at the middle of a shorter one.
double land_behind_m(const ProfileGraph& graph, const GraphWay& tunnel, bool is_first,
                     const map::Heightfield& heights) {
  const std::span<const Station> stations = graph.stations_of(tunnel);
  const double long_m = stations.back().at_m, inside_m = std::min(kPortalLength_m, long_m / 2);
  const double at_m = is_first ? inside_m : long_m - inside_m;
  const std::uint32_t i = station_before(graph, tunnel, at_m);
  const double share = (at_m - stations[i].at_m) / (stations[i + 1].at_m - stations[i].at_m);
  const Vec2 from = graph.nodes[stations[i].node].at, to = graph.nodes[stations[i + 1].node].at;
  return map::height_m_at(heights, from + (to - from) * std::clamp(share, 0.0, 1.0));
}

// The height of a mouth at which the land covers the tunnel; no farther below the land at the mouth than flat land
// needs.
double covered_m(const ProfileGraph& graph, const GraphWay& tunnel, bool is_first, const map::Heightfield& heights) {
  const std::span<const Station> stations = graph.stations_of(tunnel);
  const Vec2 mouth = graph.nodes[(is_first ? stations.front() : stations.back()).node].at;
  const double land_m = std::max(land_behind_m(graph, tunnel, is_first, heights), map::height_m_at(heights, mouth));
  return land_m - bore_height_m(tunnel.track->surface) - kBoreCover_m;
}

// A short tunnel without a layer may be a passage through a building.
bool goes_below_land(const ProfileGraph& graph, const GraphWay& way) {
  if (way.track->passage != Passage::kTunnel || !needs_cover(*way.track)) return false;
  return way.track->layer < 0 || graph.stations_of(way).back().at_m > map::kLongestPassage_m;
}

// The mouths of a graph's tunnels that the land does not cover, by node.
std::vector<Mouth> open_mouths(const ProfileGraph& graph, const map::Heightfield& heights,
                               std::span<const double> z_m) {
  std::vector<Mouth> mouths;
  for (const GraphWay& way : graph.ways) {
    if (!goes_below_land(graph, way)) continue;
    if (graph.lines == Lines::kGraded && !has_profile(way.track->surface)) continue;
    for (const bool is_first : {true, false}) {
      const std::uint32_t node = (is_first ? graph.stations_of(way).front() : graph.stations_of(way).back()).node;
      if (!is_mouth(graph, node)) continue;
      const double wanted_m = covered_m(graph, way, is_first, heights);
      if (wanted_m < z_m[node] - kLeastDescent_m) mouths.push_back({node, wanted_m});
    }
  }
  std::ranges::sort(mouths, {}, [](const Mouth& m) { return std::pair(m.node, m.wanted_m); });
  return mouths;
}

struct MouthLowering {
  const ProfileGraph& graph;
  std::vector<double> z_m;
  GraphWalk walk;
  std::vector<bool> is_kept;  // by node: its height stays

  void keep_junctions();
  void keep_indoors();
  void keep_crossed(std::span<const std::int64_t> nodes);
  double cost_m(const Leg& leg) const { return limit_of(graph, leg) * leg.length_m; }
  double least_share(std::uint32_t mouth) const;
  std::vector<Reached> reach(const Mouth& mouth, double share);
  void lower(const Mouth& mouth);
};

// Nodes where lines part or end keep their heights: other lines would go down with them.
void MouthLowering::keep_junctions() {
  std::vector<bool> is_busy;  // by junction
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    const std::uint32_t most = is_mouth(graph, n) ? 1 : 2;
    const bool parts = graph.lines == Lines::kGraded && legs_on_ground(graph, n) > most;
    const bool meets_bridge = std::ranges::any_of(
        graph.legs_of(n), [&](const Leg& leg) { return passage_of(graph, leg) == Passage::kBridge; });
    const bool is_end = node.is_on_ground && node.legs == 1;
    is_kept[n] = parts || meets_bridge || is_end || (node.is_pinned && !node.is_free_end);
    if (!parts || node.junction == kNone) continue;
    if (node.junction >= is_busy.size()) is_busy.resize(node.junction + 1);
    is_busy[node.junction] = true;
  }
  for (std::uint32_t n = 0; n < graph.nodes.size(); ++n)
    if (graph.nodes[n].junction < is_busy.size() && is_busy[graph.nodes[n].junction]) is_kept[n] = true;
}

// Floors of buildings stay.
void MouthLowering::keep_indoors() {
  for (const GraphWay& way : graph.ways) {
    if (way.road == kNone || !(way.track->is_indoor || way.track->is_through_building)) continue;
    for (const Station& station : graph.stations_of(way)) is_kept[station.node] = true;
  }
}

// Keeps the stations before and after each place where a line on the ground has one of the map nodes; not mouths, since
// a path may pass in front of them.
void MouthLowering::keep_crossed(std::span<const std::int64_t> nodes) {
  for (const GraphWay& way : graph.ways) {
    if (way.road == kNone) continue;
    const std::vector<double> along = roads::distances_along(way.track->axis, 0);
    for (std::size_t v = 0; v < along.size(); ++v) {
      if (!std::ranges::binary_search(nodes, way.track->node_ids[v])) continue;
      for (const Station& station : graph.stations_of(way).subspan(station_before(graph, way, along[v]), 2))
        if (!is_mouth(graph, station.node)) is_kept[station.node] = true;
    }
  }
}

double MouthLowering::least_share(std::uint32_t mouth) const {
  const bool has_ramp = std::ranges::all_of(graph.legs_of(mouth), [&](const Leg& leg) {
    return map::values_of(graph.ways[leg.way].track->surface).group == map::LandCoverGroup::kPath &&
           graph.ways[leg.way].track->surface != map::LandCoverClass::kSteps;
  });
  return has_ramp ? kPathRampShare : kRampShare;
}

// Returns the nodes that a descent to a mouth may move, or that stay and limit it.
std::vector<Reached> MouthLowering::reach(const Mouth& mouth, double share) {
  std::vector<Reached> reached;
  walk.from(
      mouth.node, kFar_m, [&](const Leg& leg) { return cost_m(leg); },
      [&](std::uint32_t node, double cost_m) {
        reached.push_back({node, cost_m});
        return !is_kept[node] && mouth.wanted_m + drop_m(share * cost_m) < z_m[node] + kFoot_m;
      });
  return reached;
}

// Lowers a mouth as far as the nodes that stay allow, and the lines to it at one share of their limits.
void MouthLowering::lower(const Mouth& mouth) {
  if (is_kept[mouth.node] || mouth.wanted_m >= z_m[mouth.node] - kLeastDescent_m) return;
  double share = least_share(mouth.node), least_m = mouth.wanted_m;
  const std::vector<Reached> reached = reach(mouth, share);
  for (const Reached& r : reached)
    if (is_kept[r.node]) least_m = std::max(least_m, z_m[r.node] - drop_m(r.cost_m));
  for (const Reached& r : reached)
    if (is_kept[r.node] && r.cost_m > 0)
      share = std::max(share, std::min(1.0, (z_m[r.node] - least_m + kCrest_m / 2) / r.cost_m));
  for (const Reached& r : reached) {
    const double most_m = least_m + drop_m(share * r.cost_m);
    if (!is_kept[r.node] && most_m < z_m[r.node] + kFoot_m) z_m[r.node] = -soft_max(-z_m[r.node], -most_m);
  }
}

}  // namespace

bool needs_cover(const map::Track& tunnel) {
  const bool is_path = map::values_of(tunnel.surface).group == map::LandCoverGroup::kPath;
  return is_path ? tunnel.layer < 0 : tunnel.layer <= 0;
}

std::vector<double> lower_mouths(const ProfileGraph& graph, const map::FeatureView& features,
                                 const map::Heightfield& heights, std::span<const double> z_m) {
  assert(z_m.size() == graph.nodes.size());
  MouthLowering lowering{graph, {z_m.begin(), z_m.end()}, GraphWalk(graph), std::vector<bool>(z_m.size())};
  const std::vector<Mouth> mouths = open_mouths(graph, heights, z_m);
  if (mouths.empty()) return std::move(lowering.z_m);
  lowering.keep_junctions();
  lowering.keep_indoors();
  lowering.keep_crossed(nodes_beside_graph(graph, features));
  for (const Mouth& mouth : mouths) lowering.lower(mouth);
  return std::move(lowering.z_m);
}

}  // namespace citykiln::ground

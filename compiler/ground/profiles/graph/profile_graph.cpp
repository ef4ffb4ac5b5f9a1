#include "compiler/ground/profiles/graph/profile_graph.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "compiler/geometry/snap.h"
#include "compiler/ground/profiles/graph/approach_paths.h"
#include "compiler/ground/profiles/graph/grade_rules.h"

namespace citykiln::ground {
namespace {

using map::Passage;
using map::Track;

// A vertex of a way at a place. Ways on the ground come first: ways off it join them at common map nodes.
struct WayVertex {
  Vec2 at;
  std::int64_t node_id;
  std::uint32_t way, vertex;
  bool is_off;
};

// A place on a way that gets a station.
struct Stop {
  double at_m = 0;
  std::uint32_t vertex = kNone, junction = kNone;
};

struct Draft {
  std::vector<double> along;
  std::vector<std::uint32_t> node_at;   // of each vertex; kNone without
  std::vector<std::uint32_t> junction;  // of each vertex
  std::vector<Stop> stops;
};

struct GraphBuilder {
  const map::FeatureView& features;
  std::span<const roads::Road> roads;
  Lines lines;
  std::vector<bool> is_approach;  // by track
  ProfileGraph graph;
  std::vector<Draft> drafts;
  std::vector<std::uint32_t> way_of_road;
  std::vector<std::int64_t> foreign;  // map nodes of lines with profiles in another graph, sorted

  bool is_member(std::size_t t) const;

  void add_ways();
  std::vector<WayVertex> way_vertices() const;
  void join_places();
  bool is_end(const WayVertex& p) const;
  bool is_loose_end(const WayVertex& p, std::span<const WayVertex> here) const;
  std::vector<std::vector<WayVertex>> nodes_at(std::span<const WayVertex> here) const;
  void join_place(std::span<const WayVertex> here);
  void stop_at_junctions(std::span<const roads::Junction> junctions);
  void stop_at_arm(const roads::Arm& arm, const roads::Cut& cut, std::span<const Vec2> places, std::uint32_t junction);
  void put_stations();
  void link();
  bool goes_on(std::uint32_t node) const;
  void pin();
  void pin_to_path(std::uint32_t at, bool is_approach_path);
  void pin_free_ends();
};

bool GraphBuilder::is_member(std::size_t t) const {
  const Track& track = features.tracks[t];
  const bool is_path = is_approach[t] || (leaves_ground(track) && !has_profile(track.surface));
  const bool is_line = leaves_ground(track) || has_profile(track.surface);
  return lines == Lines::kAll ? is_path || is_line : lines == Lines::kPaths ? is_path : is_line;
}

void GraphBuilder::add_ways() {
  way_of_road.assign(roads.size(), kNone);
  std::vector<std::pair<ObjectId, std::uint32_t>> road_ids;
  for (std::uint32_t r = 0; r < roads.size(); ++r) road_ids.emplace_back(roads[r].id, r);
  std::ranges::sort(road_ids);
  std::uint32_t off = 0;
  for (std::size_t t = 0; t < features.tracks.size(); ++t) {
    const Track& track = features.tracks[t];
    GraphWay way{.track = &track};
    if (leaves_ground(track)) way.off_ground = off++;
    if (!is_member(t)) {
      if (leaves_ground(track) || has_profile(track.surface))
        foreign.insert(foreign.end(), track.node_ids.begin(), track.node_ids.end());
      continue;
    }
    if (!leaves_ground(track)) {
      const auto found = std::ranges::lower_bound(road_ids, track.id, {}, &std::pair<ObjectId, std::uint32_t>::first);
      if (found == road_ids.end() || found->first != track.id) continue;
      way.road = found->second;
    }
    graph.ways.push_back(way);
  }
  std::ranges::sort(foreign);
  std::ranges::sort(graph.ways, {}, [](const GraphWay& way) { return way.track->id; });
  for (std::uint32_t w = 0; w < graph.ways.size(); ++w) {
    if (graph.ways[w].road != kNone) way_of_road[graph.ways[w].road] = w;
    const Polyline& axis = graph.ways[w].track->axis;
    drafts.push_back({roads::distances_along(axis, 0),
                      std::vector<std::uint32_t>(axis.size(), kNone),
                      std::vector<std::uint32_t>(axis.size(), kNone),
                      {}});
  }
}

std::vector<WayVertex> GraphBuilder::way_vertices() const {
  std::vector<WayVertex> way_vertices;
  for (std::uint32_t w = 0; w < graph.ways.size(); ++w) {
    const Track& track = *graph.ways[w].track;
    for (std::uint32_t v = 0; v < track.axis.size(); ++v)
      way_vertices.push_back({track.axis[v], track.node_ids[v], w, v, leaves_ground(track)});
  }
  std::ranges::sort(way_vertices, {}, [](const WayVertex& p) {
    return std::tuple(p.at.x, p.at.y, p.is_off, p.node_id, p.way, p.vertex);
  });
  return way_vertices;
}

bool GraphBuilder::is_end(const WayVertex& p) const {
  return p.vertex == 0 || p.vertex + 1 == drafts[p.way].along.size();
}

// Returns whether a way off the ground ends here at a map node that no other way has.
bool GraphBuilder::is_loose_end(const WayVertex& p, std::span<const WayVertex> here) const {
  return p.is_off && is_end(p) && std::ranges::count(here, p.node_id, &WayVertex::node_id) == 1;
}

// Returns the vertices at one place by node: first those on the ground and those off it that share a map node with
// them, then those of each other map node. Loose ends join the ground where a way on it ends too, else each other: a
// map may have two nodes where ways meet.
std::vector<std::vector<WayVertex>> GraphBuilder::nodes_at(std::span<const WayVertex> here) const {
  std::vector<std::vector<WayVertex>> nodes(1);
  const auto first_off = std::ranges::find(here, true, &WayVertex::is_off);
  const std::span<const WayVertex> ground(here.begin(), first_off);
  nodes.front().assign(ground.begin(), ground.end());
  const bool ends_on_ground = std::ranges::any_of(ground, [&](const WayVertex& g) { return is_end(g); });
  std::vector<WayVertex> loose;
  for (const WayVertex& p : here.subspan(ground.size())) {
    const bool is_loose = is_loose_end(p, here);
    if (std::ranges::count(ground, p.node_id, &WayVertex::node_id) > 0 || (is_loose && ends_on_ground))
      nodes.front().push_back(p);
    else if (is_loose)
      loose.push_back(p);
    else if (nodes.size() > 1 && nodes.back().front().node_id == p.node_id)
      nodes.back().push_back(p);
    else
      nodes.push_back({p});
  }
  nodes.push_back(std::move(loose));
  return nodes;
}

void GraphBuilder::join_place(std::span<const WayVertex> here) {
  const auto is_stop = [&](const WayVertex& p) { return is_end(p) || std::ranges::binary_search(foreign, p.node_id); };
  const auto is_in_junction = [&](const WayVertex& p) { return drafts[p.way].junction[p.vertex] != kNone; };
  for (const std::vector<WayVertex>& members : nodes_at(here)) {
    const bool matters =
        members.size() > 1 || std::ranges::any_of(members, is_stop) || std::ranges::any_of(members, is_in_junction);
    if (members.empty() || !matters) continue;
    const auto node = static_cast<std::uint32_t>(graph.nodes.size());
    graph.nodes.push_back({.at = members.front().at, .is_on_ground = !members.front().is_off});
    for (const WayVertex& p : members) drafts[p.way].node_at[p.vertex] = node;
  }
}

void GraphBuilder::join_places() {
  const std::vector<WayVertex> all = way_vertices();
  for (std::size_t i = 0; i < all.size();) {
    std::size_t j = i;
    while (j < all.size() && all[j].at == all[i].at) ++j;
    join_place(std::span(all).subspan(i, j - i));
    i = j;
  }
}

// Adds the stations of an arm that belong to its junction: up to its cut, or, on a link inside the junction, to the
// place at its other end.
void GraphBuilder::stop_at_arm(const roads::Arm& arm, const roads::Cut& cut, std::span<const Vec2> places,
                               std::uint32_t junction) {
  const std::uint32_t w = way_of_road[arm.road];
  if (w == kNone) return;
  Draft& draft = drafts[w];
  const double from_m = draft.along[arm.vertex];
  draft.junction[arm.vertex] = std::min(draft.junction[arm.vertex], junction);
  auto v = static_cast<std::int64_t>(arm.vertex) + arm.step;
  for (; v >= 0 && v < static_cast<std::int64_t>(draft.along.size()); v += arm.step) {
    const auto vertex = static_cast<std::size_t>(v);
    if (cut.length_m != roads::kWholeLink_m && std::abs(draft.along[vertex] - from_m) > cut.length_m) break;
    draft.junction[vertex] = std::min(draft.junction[vertex], junction);
    if (std::ranges::binary_search(places, graph.ways[w].track->axis[vertex])) return;
  }
  if (cut.length_m == roads::kWholeLink_m) return;
  const double cut_m = from_m + arm.step * cut.length_m, eased_m = cut_m + arm.step * kJunctionEase_m;
  const double end_m = draft.along.back();
  if (cut_m > 0 && cut_m < end_m) draft.stops.push_back({cut_m, kNone, junction});
  if (eased_m > 0 && eased_m < end_m) draft.stops.push_back({eased_m, kNone, kNone});
}

void GraphBuilder::stop_at_junctions(std::span<const roads::Junction> junctions) {
  const std::vector<std::vector<roads::Arm>> arms = roads::arms_of(junctions, roads);
  for (std::uint32_t j = 0; j < junctions.size(); ++j)
    for (std::size_t a = 0; a < arms[j].size(); ++a)
      stop_at_arm(arms[j][a], junctions[j].cuts[a], junctions[j].nodes, j);
}

// Returns stops at least kApart_m apart: those at vertices stay, others too close to them are dropped.
std::vector<Stop> apart(std::vector<Stop> stops) {
  constexpr double kApart_m = 0.5;
  std::ranges::sort(stops, {}, [](const Stop& s) { return std::tuple(s.at_m, s.vertex, s.junction); });
  std::vector<Stop> kept;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const Stop& s = stops[i];
    if (s.vertex != kNone) {
      while (!kept.empty() && kept.back().vertex == kNone && s.at_m - kept.back().at_m < kApart_m) kept.pop_back();
      kept.push_back(s);
    } else if (kept.empty() || s.at_m - kept.back().at_m >= kApart_m) {
      kept.push_back(s);
    } else if (kept.back().vertex == kNone) {
      kept.back().junction = std::min(kept.back().junction, s.junction);
    }
  }
  return kept;
}

Vec2 point_along(const Polyline& axis, std::span<const double> along, double at_m) {
  const auto after = std::ranges::upper_bound(along, at_m);
  if (after == along.end()) return axis.back();
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - along.begin(), 1));
  return axis[i - 1] + (axis[i] - axis[i - 1]) * ((at_m - along[i - 1]) / (along[i] - along[i - 1]));
}

void GraphBuilder::put_stations() {
  const double station_m = lines == Lines::kPaths ? kPathStation_m : kStation_m;
  for (std::uint32_t w = 0; w < graph.ways.size(); ++w) {
    GraphWay& way = graph.ways[w];
    Draft& draft = drafts[w];
    for (std::uint32_t v = 0; v < draft.along.size(); ++v)
      if (draft.node_at[v] != kNone) draft.stops.push_back({draft.along[v], v, draft.junction[v]});
    for (double at_m = kKnotStretch_m; at_m < draft.along.back(); at_m += kKnotStretch_m)
      draft.stops.push_back({at_m, kNone, kNone});
    const std::vector<Stop> stops = apart(std::move(draft.stops));
    way.first = static_cast<std::uint32_t>(graph.stations.size());
    const auto put = [&](double at_m, std::uint32_t junction) {
      graph.stations.push_back({at_m, static_cast<std::uint32_t>(graph.nodes.size())});
      const Vec2 at = point_along(way.track->axis, draft.along, at_m);
      graph.nodes.push_back({.at = at, .is_on_ground = way.road != kNone, .junction = junction});
    };
    for (std::size_t s = 0; s < stops.size(); ++s) {
      if (s > 0) {
        const double from_m = stops[s - 1].at_m, run_m = stops[s].at_m - from_m;
        const int pieces = std::max(1, static_cast<int>(std::ceil(run_m / station_m)));
        for (int i = 1; i < pieces; ++i) put(from_m + run_m * i / pieces, kNone);
      }
      if (stops[s].vertex == kNone) {
        put(stops[s].at_m, stops[s].junction);
      } else {
        const std::uint32_t node = draft.node_at[stops[s].vertex];
        graph.stations.push_back({stops[s].at_m, node});
        graph.nodes[node].junction = std::min(graph.nodes[node].junction, stops[s].junction);
      }
    }
    way.count = static_cast<std::uint32_t>(graph.stations.size()) - way.first;
  }
}

void GraphBuilder::link() {
  const auto each = [&](auto visit) {
    for (std::uint32_t w = 0; w < graph.ways.size(); ++w) {
      const std::span<const Station> stations = graph.stations_of(graph.ways[w]);
      for (std::size_t s = 1; s < stations.size(); ++s) visit(w, stations[s - 1], stations[s]);
    }
  };
  each([&](std::uint32_t, const Station& a, const Station& b) {
    ++graph.nodes[a.node].legs, ++graph.nodes[b.node].legs;
  });
  std::uint32_t first = 0;
  for (GraphNode& node : graph.nodes) {
    node.first_leg = first;
    first += node.legs;
    node.legs = 0;
  }
  graph.legs.resize(first);
  each([&](std::uint32_t w, const Station& a, const Station& b) {
    const double length_m = b.at_m - a.at_m;
    graph.legs[graph.nodes[a.node].first_leg + graph.nodes[a.node].legs++] = {b.node, w, length_m};
    graph.legs[graph.nodes[b.node].first_leg + graph.nodes[b.node].legs++] = {a.node, w, length_m};
  });
}

// Returns whether a bridge or tunnel continues through the node; then steps that lead to it do not pin it.
bool GraphBuilder::goes_on(std::uint32_t node) const {
  return std::ranges::count_if(graph.legs_of(node), [&](const Leg& leg) { return graph.ways[leg.way].road == kNone; }) >
         1;
}

// The end of a tunnel may fall where it meets approach paths alone, such as the steps of an underpass.
void GraphBuilder::pin_to_path(std::uint32_t at, bool is_approach_path) {
  GraphNode& node = graph.nodes[at];
  if (node.is_on_ground || goes_on(at)) return;
  const auto is_tunnel = [&](const Leg& leg) { return graph.ways[leg.way].track->passage == Passage::kTunnel; };
  const bool may_fall = is_approach_path && std::ranges::all_of(graph.legs_of(at), is_tunnel);
  node.is_free_end = may_fall && (node.is_free_end || !node.is_pinned);
  node.is_pinned = true;
}

// Pins nodes where a bridge or tunnel meets a path that follows the ground, and free ends of bridges.
void GraphBuilder::pin() {
  std::vector<std::pair<std::int64_t, std::uint32_t>> off;
  for (std::uint32_t w = 0; w < graph.ways.size(); ++w) {
    for (std::size_t v = 0; v < drafts[w].along.size(); ++v) {
      const std::uint32_t node = drafts[w].node_at[v];
      if (node == kNone) continue;
      if (graph.ways[w].road == kNone) off.emplace_back(graph.ways[w].track->node_ids[v], node);
      if (std::ranges::binary_search(foreign, graph.ways[w].track->node_ids[v])) graph.nodes[node].is_pinned = true;
    }
  }
  std::ranges::sort(off);
  for (std::size_t t = 0; t < features.tracks.size(); ++t) {
    const Track& track = features.tracks[t];
    if (leaves_ground(track) || has_profile(track.surface) || off.empty()) continue;
    if (is_approach[t] && lines != Lines::kGraded) continue;
    for (const std::int64_t id : track.node_ids) {
      auto found = std::ranges::lower_bound(off, id, {}, &std::pair<std::int64_t, std::uint32_t>::first);
      for (; found != off.end() && found->first == id; ++found) pin_to_path(found->second, is_approach[t]);
    }
  }
  pin_free_ends();
}

void GraphBuilder::pin_free_ends() {
  for (std::uint32_t w = 0; w < graph.ways.size(); ++w) {
    const GraphWay& way = graph.ways[w];
    if (way.track->passage != Passage::kBridge) continue;
    for (const std::uint32_t end : {drafts[w].node_at.front(), drafts[w].node_at.back()}) {
      GraphNode& node = graph.nodes[end];
      if (!node.is_on_ground && !node.is_pinned && node.legs == 1) node.is_free_end = node.is_pinned = true;
    }
  }
}

}  // namespace

bool leaves_ground(const Track& track) { return track.passage != Passage::kGround; }

ProfileGraph graph_of(const map::FeatureView& features, std::span<const roads::Road> roads,
                      std::span<const roads::Junction> junctions, Lines lines) {
  GraphBuilder builder{features, roads, lines, approach_paths(features), {}, {}, {}, {}};
  builder.graph.lines = lines;
  builder.add_ways();
  builder.stop_at_junctions(junctions);
  builder.join_places();
  builder.put_stations();
  builder.link();
  builder.pin();
  return std::move(builder.graph);
}

std::uint32_t station_before(const ProfileGraph& graph, const GraphWay& way, double at_m) {
  assert(way.count >= 2);
  const std::span<const Station> stations = graph.stations_of(way);
  const auto after = std::ranges::upper_bound(stations, at_m, {}, &Station::at_m);
  const auto i = static_cast<std::uint32_t>(after - stations.begin());
  return std::clamp(i, 1u, way.count - 1) - 1;
}

double height_along(const ProfileGraph& graph, const GraphWay& way, std::span<const double> z_m, double at_m) {
  assert(z_m.size() == graph.nodes.size());
  const std::uint32_t i = station_before(graph, way, at_m);
  const Station &a = graph.stations[way.first + i], &b = graph.stations[way.first + i + 1];
  const double t = std::clamp((at_m - a.at_m) / (b.at_m - a.at_m), 0.0, 1.0);
  return z_m[a.node] + (z_m[b.node] - z_m[a.node]) * t;
}

std::vector<double> negated(std::span<const double> z_m) {
  std::vector<double> turned;
  for (const double z : z_m) turned.push_back(-z);
  return turned;
}

}  // namespace citykiln::ground

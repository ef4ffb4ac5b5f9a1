#include "compiler/ground/profiles/crossings/crossings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "compiler/contract/erase_repeated.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/graph/graph_walk.h"

namespace citykiln::ground {
namespace {

using map::LandCoverGroup;
using map::Passage;
using map::Track;

// Largest width of a line to one side.
constexpr double kWidest_m = 16;
// Sampling distance along a line for what lies beside it.
constexpr double kEvery_m = 4;

LandCoverGroup group_of(const Track& track) { return map::values_of(track.surface).group; }

double half_width_m(const Track& track) {
  const double width_m = map::carriageway_width_m(track.section), left_m = track.section.axis_offset_m;
  return std::min(std::max(left_m, width_m - left_m), kWidest_m);
}

int map_layer_of(const Track& track) {
  if (track.layer != 0 || track.passage == Passage::kGround) return track.layer;
  return track.passage == Passage::kBridge ? 1 : -1;
}

std::pair<int, int> rank_of(const Track& track) {
  if (track.passage == Passage::kGround) return {1, 0};
  return {track.passage == Passage::kBridge ? 2 : 0, map_layer_of(track)};
}

bool is_corridor(const Track& track) {
  return track.passage == Passage::kTunnel && group_of(track) == LandCoverGroup::kPath && track.layer >= 0;
}

// A piece of a line that may be crossed: of a way of the graph, a path on the ground, or a stream.
struct Segment {
  Vec2 a, b;
  double at_m = 0;  // of a, along its line
  std::uint32_t way = kNone, path = kNone, stream = kNone;
};

constexpr double kCrossingBucket_m = 32;

// Boxes about lines off the ground: the rest of the map has no crossings.
BoxGrid grid_of_off_ground(const ProfileGraph& graph) {
  std::vector<Box2> boxes;
  for (const GraphWay& way : graph.ways)
    for (std::size_t i = 0; way.road == kNone && i + 1 < way.track->axis.size(); ++i)
      boxes.push_back(box_of(std::span(way.track->axis).subspan(i, 2)).widened(2 * kWidest_m));
  return grid_of(boxes, kCrossingBucket_m);
}

bool share_a_node(const Track& a, const Track& b) {
  return std::ranges::any_of(a.node_ids,
                             [&](std::int64_t id) { return std::ranges::find(b.node_ids, id) != b.node_ids.end(); });
}

struct Finder {
  const ProfileGraph& graph;
  const map::FeatureView& features;
  const BelowBridges& below;
  BoxGrid off_ground;
  GraphWalk walk;
  std::vector<Segment> segments = {};
  std::vector<Box2> boxes = {};  // of the segments
  BoxGrid grid = {};             // of the boxes
  std::vector<Crossing> found = {};
  std::vector<UnorderedPair> unordered = {};

  template <typename Name>
  void add_line(const Polyline& axis, Name name) {
    double at_m = 0;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      Segment segment{axis[i], axis[i + 1], at_m};
      name(segment);
      at_m += snapped(distance(axis[i], axis[i + 1]));
      const Box2 box = box_of(std::span(axis).subspan(i, 2));
      if (!is_any_about(off_ground, box)) continue;
      segments.push_back(segment), boxes.push_back(box);
    }
  }

  bool is_in_graph(const Track& track) const {
    const auto id = [](const GraphWay& way) { return way.track->id; };
    return std::ranges::binary_search(graph.ways, track.id, {}, id);
  }

  void add_lines() {
    for (std::uint32_t w = 0; w < graph.ways.size(); ++w)
      add_line(graph.ways[w].track->axis, [&](Segment& s) { s.way = w; });
    for (std::uint32_t t = 0; t < features.tracks.size(); ++t) {
      const Track& track = features.tracks[t];
      if (!leaves_ground(track) && group_of(track) == LandCoverGroup::kPath && !is_in_graph(track))
        add_line(track.axis, [&](Segment& s) { s.path = t; });
    }
    for (std::uint32_t i = 0; i < below.streams.size(); ++i)
      add_line(below.streams[i].axis, [&](Segment& s) { s.stream = i; });
    grid = grid_of(boxes, kCrossingBucket_m);
  }

  double joining_m(const Leg& leg) const {
    const Track& track = *graph.ways[leg.way].track;
    return (group_of(track) == LandCoverGroup::kRail ? kRailJoins
            : has_profile(track.surface)             ? 1
                                                     : kPathJoins) *
           leg.length_m;
  }

  // Returns whether a bridge goes on as a tunnel: below what the bridge's other parts may pass over.
  bool changes_passage(std::uint32_t node) const {
    const auto leads_to = [&](Passage passage) {
      return std::ranges::any_of(graph.legs_of(node),
                                 [&](const Leg& leg) { return graph.ways[leg.way].track->passage == passage; });
    };
    return leads_to(Passage::kBridge) && leads_to(Passage::kTunnel);
  }

  // Returns where a way off the ground comes down within kJoined_m.
  std::vector<Vec2> landings_of(std::uint32_t way, double at_m) {
    std::vector<Vec2> landings;
    if (graph.ways[way].road != kNone) return landings;
    walk.from(
        starts_about(graph, way, at_m), kJoined_m,
        [&](const Leg& leg) { return graph.ways[leg.way].road == kNone ? joining_m(leg) : 2 * kJoined_m; },
        [&](std::uint32_t node, double) {
          const GraphNode& n = graph.nodes[node];
          if (n.is_on_ground || n.is_pinned || changes_passage(node)) landings.push_back(n.at);
          return true;
        });
    return landings;
  }

  // Returns whether two bridges or two tunnels that overlap so far apart lie side by side: neither axis is over the
  // other's carriageway.
  bool are_side_by_side(std::uint32_t a, std::uint32_t b, double apart_m) const {
    const Track &one = *graph.ways[a].track, &two = *graph.ways[b].track;
    return one.passage == two.passage && apart_m >= std::max(half_width_m(one), half_width_m(two));
  }

  // Returns whether one of the landings lies on another way.
  bool are_beside(std::span<const Vec2> landings, std::uint32_t way, std::uint32_t other) const {
    const Track& beside = *graph.ways[other].track;
    const double reach_m = half_width_m(*graph.ways[way].track) + half_width_m(beside);
    return std::ranges::any_of(landings, [&](Vec2 at) { return distance_to_polyline(beside.axis, at) < reach_m; });
  }

  // Returns whether a way on the ground goes on, within kJoined_m, as a bridge or tunnel that begins beside another in
  // the same order: both come down side by side.
  bool leads_to_twin(std::uint32_t way, double way_m, std::uint32_t of) {
    if (graph.ways[way].road == kNone) return false;
    const Track& beside = *graph.ways[of].track;
    const auto is_twin = [&](const Leg& leg) {
      const Track& track = *graph.ways[leg.way].track;
      return leg.way != of && leaves_ground(track) && rank_of(track) == rank_of(beside);
    };
    bool found_twin = false;
    walk.from(
        starts_about(graph, way, way_m), kJoined_m,
        [&](const Leg& leg) { return graph.ways[leg.way].road == kNone ? 2 * kJoined_m : joining_m(leg); },
        [&](std::uint32_t node, double) {
          found_twin |= std::ranges::any_of(graph.legs_of(node), is_twin) &&
                        distance_to_polyline(beside.axis, graph.nodes[node].at) < kWidest_m;
          return !found_twin;
        });
    return found_twin;
  }

  // Returns whether the lines are connected within kJoined_m along the network.
  bool are_joined(std::uint32_t a, double a_m, std::uint32_t b, double b_m) {
    const std::uint32_t i = station_before(graph, graph.ways[a], a_m), j = station_before(graph, graph.ways[b], b_m);
    const Station* from = &graph.stations[graph.ways[a].first + i];
    const Station* to = &graph.stations[graph.ways[b].first + j];
    const GraphWalk::Start starts[2] = {{joining_m({0, a, std::abs(a_m - from[0].at_m)}), from[0].node},
                                        {joining_m({0, a, std::abs(a_m - from[1].at_m)}), from[1].node}};
    bool joined = false;
    walk.from(
        starts, kJoined_m, [&](const Leg& leg) { return joining_m(leg); },
        [&](std::uint32_t node, double run_m) {
          for (int k = 0; k < 2; ++k)
            joined |= to[k].node == node && run_m + joining_m({0, b, std::abs(b_m - to[k].at_m)}) <= kJoined_m;
          return !joined;
        });
    return joined;
  }

  bool passes_a_mouth(const Track& upper, std::uint32_t lower, double at_m) const {
    const GraphWay& way = graph.ways[lower];
    return way.track->passage == Passage::kTunnel && !leaves_ground(upper) && !has_profile(upper.surface) &&
           std::min(at_m, graph.stations_of(way).back().at_m - at_m) < kMouth_m;
  }

  void add_ways(std::uint32_t a, double a_m, std::uint32_t b, double b_m) {
    const Track &one = *graph.ways[a].track, &two = *graph.ways[b].track;
    if (rank_of(one) == rank_of(two) || is_corridor(one) || is_corridor(two)) return;
    if (rank_of(one) < rank_of(two)) return add_ways(b, b_m, a, a_m);
    if (are_joined(a, a_m, b, b_m) || passes_a_mouth(one, b, b_m)) return;
    found.push_back({.upper = a,
                     .lower = b,
                     .upper_at_m = a_m,
                     .lower_at_m = b_m,
                     .wanted_m = wanted_clearance_m(one.surface, two.surface),
                     .half_width_m = half_width_m(two),
                     .is_contradictory = layers_contradict(one, two)});
  }

  void add_path_above(std::uint32_t way, double at_m, const Segment& other, double ground_m) {
    if (other.path == kNone) return;
    const Track &tunnel = *graph.ways[way].track, &path = features.tracks[other.path];
    if (share_a_node(tunnel, path) || is_corridor(tunnel) || passes_a_mouth(path, way, at_m)) return;
    found.push_back({.upper = kNone,
                     .lower = way,
                     .lower_at_m = at_m,
                     .upper_z_m = ground_m,
                     .wanted_m = wanted_clearance_m(path.surface, tunnel.surface),
                     .half_width_m = half_width_m(tunnel),
                     .outside = path.id.osm,
                     .is_contradictory = layers_contradict(path, tunnel)});
  }

  void add(std::uint32_t way, double at_m, const Segment& other, double along) {
    const double other_m = other.at_m + along * distance(other.a, other.b);
    if (other.way != kNone) return add_ways(way, at_m, other.way, other_m);
    const Track& track = *graph.ways[way].track;
    const Vec2 at = other.a + (other.b - other.a) * along;
    const double ground_m = below.ground_m(at);
    if (track.passage == Passage::kTunnel) return add_path_above(way, at_m, other, ground_m);
    if (other.path != kNone) {
      const Track& path = features.tracks[other.path];
      if (share_a_node(track, path)) return;
      found.push_back({.upper = way,
                       .upper_at_m = at_m,
                       .lower_z_m = ground_m,
                       .wanted_m = wanted_clearance_m(track.surface, path.surface),
                       .half_width_m = half_width_m(path),
                       .outside = path.id.osm,
                       .is_contradictory = layers_contradict(track, path)});
    } else {
      const roads::Strip& stream = below.streams[other.stream];
      const double z_m =
          stream.profile.empty() ? ground_m : knot_at(stream.profile, stream.start_along_m + other_m).z_m;
      found.push_back({.upper = way,
                       .upper_at_m = at_m,
                       .lower_z_m = z_m,
                       .wanted_m = wanted_clearance_over_water_m(stream.left_m + stream.right_m),
                       .half_width_m = std::max(stream.left_m, stream.right_m),
                       .outside = stream.id.osm});
    }
  }

  // Calls visit(distance along the way, segment, share along it) where axes cross; for two ways off the ground once.
  template <typename Visit>
  void for_each_intersection(std::uint32_t w, Visit visit) {
    const Polyline& axis = graph.ways[w].track->axis;
    double at_m = 0;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      const double length_m = snapped(distance(axis[i], axis[i + 1]));
      for (const std::uint32_t s : boxes_about(grid, box_of(std::span(axis).subspan(i, 2)))) {
        const Segment& other = segments[s];
        if (other.way == w) continue;
        if (other.way != kNone && graph.ways[other.way].road == kNone && other.way < w) continue;
        if (const auto hit = crossing_shares(axis[i], axis[i + 1], other.a, other.b))
          visit(at_m + hit->first * length_m, other, hit->second);
      }
      at_m += length_m;
    }
  }

  void find_intersections(std::uint32_t w) {
    for_each_intersection(w, [&](double at_m, const Segment& other, double along) { add(w, at_m, other, along); });
  }

  void find_unordered(std::uint32_t w) {
    for_each_intersection(w, [&](double at_m, const Segment& other, double along) {
      if (other.way == kNone) return;
      const Track &one = *graph.ways[w].track, &two = *graph.ways[other.way].track;
      if (rank_of(one) != rank_of(two) || is_corridor(one) || is_corridor(two)) return;
      if (are_joined(w, at_m, other.way, other.at_m + along * distance(other.a, other.b))) return;
      const auto [first, second] = std::minmax(one.id.osm, two.id.osm);
      if (first != second) unordered.push_back({first, second});
    });
  }

  // Calls visit(distance along the way, place) at its stations and between them, at most kEvery_m apart.
  template <typename Visit>
  void for_each_place(std::uint32_t w, Visit visit) {
    const std::span<const Station> stations = graph.stations_of(graph.ways[w]);
    for (std::size_t s = 0; s + 1 < stations.size(); ++s) {
      const Vec2 from = graph.nodes[stations[s].node].at, to = graph.nodes[stations[s + 1].node].at;
      const double run_m = stations[s + 1].at_m - stations[s].at_m;
      const int pieces = std::max(1, static_cast<int>(std::ceil(run_m / kEvery_m)));
      for (int k = s == 0 ? 0 : 1; k <= pieces; ++k) {
        const double t = static_cast<double>(k) / pieces;
        visit(stations[s].at_m + run_m * t, from + (to - from) * t);
      }
    }
  }

  // Finds lines below or above this one along its length.
  void find_overlaps(std::uint32_t w) {
    for_each_place(w, [&](double at_m, Vec2 at) { find_overlaps(w, at_m, at); });
  }

  void find_overlaps(std::uint32_t w, double at_m, Vec2 at) {
    const double half_m = half_width_m(*graph.ways[w].track);
    std::optional<std::vector<Vec2>> landings;  // the same for all segments near
    for (const std::uint32_t s : boxes_about(grid, Box2{at, at}.widened(half_m + kWidest_m))) {
      const Segment& other = segments[s];
      if (other.way == kNone || other.way == w) continue;
      const double along = nearest_share(other.a, other.b, at);
      const double apart_m = distance(at, other.a + (other.b - other.a) * along);
      if (apart_m >= half_m + half_width_m(*graph.ways[other.way].track)) continue;
      if (are_side_by_side(w, other.way, apart_m)) continue;
      const double other_m = other.at_m + along * distance(other.a, other.b);
      if (!landings) landings = landings_of(w, at_m);
      if (are_beside(*landings, w, other.way) || are_beside(landings_of(other.way, other_m), other.way, w)) continue;
      if (!leads_to_twin(other.way, other_m, w)) add(w, at_m, other, along);
    }
  }

  void find_waters(std::uint32_t w) {
    if (graph.ways[w].track->passage != Passage::kBridge) return;
    for (const LandCoverPolygon& water : below.waters) {
      if (!water.level_m) continue;
      const Box2 box = box_of(water);
      for_each_place(w, [&](double at_m, Vec2 at) {
        if (box.contains(at) && winding_number(water, at) > 0)
          found.push_back({.upper = w,
                           .upper_at_m = at_m,
                           .lower_z_m = *water.level_m,
                           .wanted_m = kClearanceOverWater_m,
                           .outside = water.id.osm});
      });
    }
  }
};

}  // namespace

bool layers_contradict(const Track& upper, const Track& lower) {
  if (upper.passage == lower.passage && (upper.layer == 0 || lower.layer == 0)) return true;
  return map_layer_of(upper) <= map_layer_of(lower);
}

double wanted_clearance_m(map::LandCoverClass upper, map::LandCoverClass lower) {
  const bool is_thin = map::values_of(upper).group == LandCoverGroup::kPath;
  const LandCoverGroup below = map::values_of(lower).group;
  if (below == LandCoverGroup::kPath && lower != map::LandCoverClass::kFarmTrack) return kClearanceOverPath_m;
  const bool is_railway = lower == map::LandCoverClass::kRailway || lower == map::LandCoverClass::kFunicular;
  return (is_railway ? kClearanceOverRail_m : kClearanceOverRoad_m) - (is_thin ? kThinDeck_m : 0);
}

double wanted_clearance_over_water_m(double width_m) {
  assert(width_m >= 0);
  return std::max(kClearanceOverDitch_m, kClearanceOverWater_m * std::min(1.0, width_m / kRiver_m));
}

std::vector<Crossing> find_crossings(const ProfileGraph& graph, const map::FeatureView& features,
                                     const BelowBridges& below) {
  Finder finder{graph, features, below, grid_of_off_ground(graph), GraphWalk(graph)};
  finder.add_lines();
  for (std::uint32_t w = 0; w < graph.ways.size(); ++w) {
    if (graph.ways[w].road != kNone) continue;
    finder.find_intersections(w);
    finder.find_overlaps(w);
    finder.find_waters(w);
  }
  std::ranges::sort(finder.found, {}, [](const Crossing& c) {
    return std::tuple(c.upper, c.upper_at_m, c.lower, c.lower_at_m, c.lower_z_m, c.upper_z_m);
  });
  return std::move(finder.found);
}

std::vector<UnorderedPair> find_unordered(const ProfileGraph& graph, const map::FeatureView& features) {
  const BelowBridges nothing{};
  Finder finder{graph, features, nothing, grid_of_off_ground(graph), GraphWalk(graph)};
  finder.add_lines();
  for (std::uint32_t w = 0; w < graph.ways.size(); ++w)
    if (graph.ways[w].road == kNone) finder.find_unordered(w);
  sort_unique(finder.unordered);
  return std::move(finder.unordered);
}

double clearance_shortfall_m(const ProfileGraph& graph, const Crossing& crossing, std::span<const double> z_m) {
  assert(z_m.size() == graph.nodes.size());
  const double upper_m = crossing.upper == kNone
                             ? crossing.upper_z_m
                             : height_along(graph, graph.ways[crossing.upper], z_m, crossing.upper_at_m);
  const double lower_m = crossing.lower == kNone
                             ? crossing.lower_z_m
                             : height_along(graph, graph.ways[crossing.lower], z_m, crossing.lower_at_m);
  return lower_m + crossing.wanted_m - upper_m;
}

}  // namespace citykiln::ground

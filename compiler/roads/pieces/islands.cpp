#include "compiler/roads/pieces/islands.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "compiler/geometry/box.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/network.h"

namespace citykiln::roads {
namespace {

constexpr double kLargest_m2 = 300;
constexpr double kLargestPaved_m2 = 80;
constexpr std::size_t kMostSides = 96;

// A directed segment of an axis: a half-edge of the street network.
struct HalfEdge {
  Vec2 from, to;
  std::uint32_t road;
  auto operator<=>(const HalfEdge&) const = default;
};

std::vector<HalfEdge> half_edges_of(std::span<const Road> roads) {
  std::vector<HalfEdge> half_edges;
  for (std::uint32_t r = 0; r < roads.size(); ++r) {
    if (!is_through_street(roads[r])) continue;
    const Polyline& axis = roads[r].axis;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      half_edges.push_back({axis[i], axis[i + 1], r});
      half_edges.push_back({axis[i + 1], axis[i], r});
    }
  }
  std::ranges::sort(half_edges);
  return half_edges;
}

// 0: less than half a turn clockwise of `back`; 1: opposite; 2: more than half a turn; 3: `back` itself.
int turn_from(Vec2 back, Vec2 v) {
  const double turn = cross(back, v);
  if (turn == 0) return dot(back, v) < 0 ? 1 : 3;
  return turn < 0 ? 0 : 2;
}

// The next half-edge of the face to the left: the first one clockwise of where `half_edge` comes from.
const HalfEdge* next_half_edge(std::span<const HalfEdge> half_edges, const HalfEdge& half_edge) {
  const Vec2 back = half_edge.from - half_edge.to;
  const HalfEdge* best = nullptr;
  const auto comes_first = [&](const HalfEdge& a, const HalfEdge& b) {
    const Vec2 u = a.to - a.from, v = b.to - b.from;
    if (turn_from(back, u) != turn_from(back, v)) return turn_from(back, u) < turn_from(back, v);
    return cross(u, v) < 0;
  };
  for (auto s = std::ranges::lower_bound(half_edges, half_edge.to, {}, &HalfEdge::from);
       s != half_edges.end() && s->from == half_edge.to; ++s)
    if (!best || comes_first(*s, *best)) best = &*s;
  return best;
}

// The face to the left of `first`, if `first` is its lowest half-edge and the face is small; else empty.
std::vector<const HalfEdge*> face_from(std::span<const HalfEdge> half_edges, const HalfEdge& first) {
  std::vector<const HalfEdge*> face;
  Box2 box;
  for (const HalfEdge* half_edge = &first; half_edge != nullptr; half_edge = next_half_edge(half_edges, *half_edge)) {
    if (half_edge == &first && !face.empty()) return face;
    face.push_back(half_edge);
    box.grow(half_edge->from);
    if (*half_edge < first || face.size() > kMostSides) break;
    if (std::max(box.width(), box.height()) > kWidestIsland_m) break;
  }
  return {};
}

// The island that fills a face, or nothing where the face is too large or crosses itself.
std::vector<TrafficIsland> island_in(std::span<const Road> roads, const std::vector<const HalfEdge*>& face) {
  Ring ring;
  bool is_roundabout = true;
  ObjectId id = face.empty() ? ObjectId{} : roads[face.front()->road].id;
  for (const HalfEdge* half_edge : face) {
    ring.push_back(half_edge->from);
    is_roundabout = is_roundabout && roads[half_edge->road].is_roundabout;
    id = std::min(id, roads[half_edge->road].id);
  }
  const double area = ring.size() < 3 ? 0 : signed_area_m2(ring);
  if (area <= 0 || (!is_roundabout && area > kLargest_m2) || !is_simple(ring)) return {};
  const bool is_planted = is_roundabout && area > kLargestPaved_m2;
  return {{id, is_planted ? map::LandCoverClass::kVerge : map::LandCoverClass::kIsland, std::move(ring)}};
}

// Islands at marked nodes. A node of several streets belongs to the one with the lowest id.
std::vector<TrafficIsland> islands_at_nodes(std::span<const Road> roads) {
  std::map<std::pair<Vec2, map::LandCoverClass>, ObjectId> nodes;
  for (const Road& road : roads)
    for (const map::TrackPoint& point : road.points) {
      const bool is_loop = point.kind == map::TrackPointKind::kTurningLoop;
      if (!is_loop && point.kind != map::TrackPointKind::kMiniRoundabout) continue;
      const auto surface = is_loop ? map::LandCoverClass::kTrafficIsland : map::LandCoverClass::kPaintedIsland;
      const auto [node, is_new] = nodes.try_emplace({road.axis[point.vertex], surface}, road.id);
      node->second = std::min(node->second, road.id);
    }
  std::vector<TrafficIsland> islands;
  for (const auto& [node, id] : nodes) {
    const bool is_loop = node.second == map::LandCoverClass::kTrafficIsland;
    islands.push_back({id, node.second, sixteen_gon(node.first, is_loop ? kLoopIsland_m : kPaintedCircle_m)});
  }
  return islands;
}

}  // namespace

std::vector<TrafficIsland> islands_of(std::span<const Road> roads) {
  const std::vector<HalfEdge> half_edges = half_edges_of(roads);
  std::vector<TrafficIsland> islands = islands_at_nodes(roads);
  for (const HalfEdge& half_edge : half_edges)
    for (TrafficIsland& island : island_in(roads, face_from(half_edges, half_edge)))
      islands.push_back(std::move(island));
  std::ranges::sort(islands, {}, [](const TrafficIsland& i) { return std::tie(i.id, i.surface, i.ring); });
  return islands;
}

}  // namespace citykiln::roads

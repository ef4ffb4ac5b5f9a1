#include "compiler/invent/town/streets/street_graph.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::invent {
namespace {

constexpr double kStreetBucket_m = 32;

}  // namespace

Vec2 on_place_grid(Vec2 p) { return snapped_to(kPlaceStep_m, p); }

StreetGraph::StreetGraph(double side_m)
    : half_m_(side_m / 2),
      columns_(static_cast<int>(side_m / kStreetBucket_m) + 1),
      buckets_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(columns_)) {}

std::uint32_t StreetGraph::other_end(std::uint32_t segment, std::uint32_t vertex) const {
  const StreetSegment& s = segments_[segment];
  return s.a == vertex ? s.b : s.a;
}

Vec2 StreetGraph::direction_from(std::uint32_t vertex, std::uint32_t segment) const {
  return unit(position(other_end(segment, vertex)) - position(vertex));
}

std::uint32_t StreetGraph::add_vertex(Vec2 p) {
  vertices_.push_back({on_place_grid(p)});
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

std::uint32_t StreetGraph::add_segment(std::uint32_t a, std::uint32_t b, std::uint32_t street, bool is_bridge) {
  const auto segment = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back({a, b, street, is_bridge});
  vertices_[a].segments.push_back(segment);
  vertices_[b].segments.push_back(segment);
  put_in_buckets(segment);
  return segment;
}

void StreetGraph::remove_segment(std::uint32_t segment) {
  segments_[segment].is_removed = true;
  std::erase(vertices_[segments_[segment].a].segments, segment);
  std::erase(vertices_[segments_[segment].b].segments, segment);
}

std::uint32_t StreetGraph::split(std::uint32_t segment, Vec2 p) {
  const StreetSegment whole = segments_[segment];
  const std::uint32_t middle = add_vertex(p);
  remove_segment(segment);
  add_segment(whole.a, middle, whole.street, whole.is_bridge);
  add_segment(middle, whole.b, whole.street, whole.is_bridge);
  return middle;
}

bool StreetGraph::are_joined(std::uint32_t a, std::uint32_t b) const {
  return std::ranges::any_of(vertices_[a].segments, [&](std::uint32_t s) { return other_end(s, a) == b; });
}

int StreetGraph::column(double x) const {
  return std::clamp(static_cast<int>((x + half_m_) / kStreetBucket_m), 0, columns_ - 1);
}

void StreetGraph::put_in_buckets(std::uint32_t segment) {
  const Box2 box = box_of_segment(position(segments_[segment].a), position(segments_[segment].b));
  for (int row = column(box.min.y); row <= column(box.max.y); ++row)
    for (int i = column(box.min.x); i <= column(box.max.x); ++i)
      buckets_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)]
          .push_back(segment);
}

std::vector<std::uint32_t> StreetGraph::near(const Box2& box) const {
  std::vector<std::uint32_t> found;
  for (int row = column(box.min.y); row <= column(box.max.y); ++row)
    for (int i = column(box.min.x); i <= column(box.max.x); ++i)
      for (const std::uint32_t segment :
           buckets_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)])
        if (!segments_[segment].is_removed) found.push_back(segment);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::optional<StreetHit> StreetGraph::first_hit(std::uint32_t from, Vec2 to) const {
  const Vec2 p = position(from);
  std::optional<StreetHit> first;
  for (const std::uint32_t segment : near(box_of_segment(p, to))) {
    const StreetSegment& s = segments_[segment];
    if (s.a == from || s.b == from) continue;
    const auto shares = crossing_shares(p, to, position(s.a), position(s.b));
    if (shares && (!first || shares->first < first->share))
      first = StreetHit{segment, shares->first, p + (to - p) * shares->first};
  }
  return first;
}

bool StreetGraph::is_clear(std::uint32_t from, std::uint32_t to) const {
  const Vec2 a = position(from), b = position(to);
  for (const std::uint32_t segment : near(box_of_segment(a, b))) {
    const StreetSegment& s = segments_[segment];
    if (s.a == from || s.b == from || s.a == to || s.b == to) continue;
    if (crossing_shares(a, b, position(s.a), position(s.b))) return false;
  }
  return true;
}

std::uint32_t StreetGraph::nearest_vertex(Vec2 p, double within_m) const {
  std::uint32_t nearest = kNoStreetVertex;
  double least_m = within_m;
  for (const std::uint32_t segment : near(box_of_segment(p, p).widened(within_m)))
    for (const std::uint32_t vertex : {segments_[segment].a, segments_[segment].b})
      if (const double d = distance(position(vertex), p); d < least_m) {
        least_m = d;
        nearest = vertex;
      }
  return nearest;
}

namespace {

// the vertex of a hit segment that is near enough and in sight, else a new one
std::uint32_t vertex_of_hit(StreetGraph& graph, std::uint32_t from, const StreetHit& hit, double snap_m) {
  const StreetSegment segment = graph.segments()[hit.segment];
  for (const std::uint32_t end : {segment.a, segment.b})
    if (distance(graph.position(end), hit.place) < snap_m && graph.is_clear(from, end)) return end;
  return graph.split(hit.segment, hit.place);
}

void join_vertices(StreetGraph& graph, std::uint32_t a, std::uint32_t b, std::uint32_t street, bool is_bridge) {
  if (a != b && !graph.are_joined(a, b)) graph.add_segment(a, b, street, is_bridge);
}

}  // namespace

std::uint32_t lay_street(StreetGraph& graph, std::uint32_t from, Vec2 to, std::uint32_t street, double snap_m,
                         bool is_bridge) {
  to = on_place_grid(to);
  for (int crossings = 0; crossings < 64; ++crossings) {
    const std::optional<StreetHit> hit = graph.first_hit(from, to);
    if (!hit) break;
    const std::uint32_t at = vertex_of_hit(graph, from, *hit, snap_m);
    join_vertices(graph, from, at, street, is_bridge);
    from = at;
  }
  if (distance(graph.position(from), to) < snap_m) return from;
  const std::uint32_t near_end = graph.nearest_vertex(to, snap_m);
  const bool use_near = near_end != kNoStreetVertex && near_end != from && graph.is_clear(from, near_end);
  const std::uint32_t end = use_near ? near_end : graph.add_vertex(to);
  join_vertices(graph, from, end, street, is_bridge);
  return end;
}

}  // namespace citykiln::invent

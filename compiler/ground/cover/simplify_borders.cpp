// Visvalingam and Whyatt 1993; Dyken, Daehlen and Sevaldrud 2009. Differences: the error of a vertex is the distance of
// everything that its removal leaves out, not an area or the vertex's own distance, so the bound is exact; a vertex
// blocked by another waits for that one to be removed.
#include "compiler/ground/cover/simplify_borders.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <queue>
#include <tuple>

#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/tolerance.h"
#include "compiler/geometry/point_buckets.h"

namespace citykiln::ground {
namespace {

std::int64_t along(GridPoint a, GridPoint b, GridPoint p) {
  return (b.x - a.x) * (p.x - a.x) + (b.y - a.y) * (p.y - a.y);
}

// Returns the distance from p to the segment a b in grid steps; exact up to the last root and quotient; the same from b
// to a.
double distance_to_segment(GridPoint a, GridPoint b, GridPoint p) {
  if (along(a, b, p) <= 0) return std::sqrt(static_cast<double>(along(a, p, p)));
  if (along(b, a, p) <= 0) return std::sqrt(static_cast<double>(along(b, p, p)));
  return std::abs(static_cast<double>(turn(a, b, p))) / std::sqrt(static_cast<double>(along(a, b, b)));
}

// Returns whether arrange() would bend a b through p, or nearly.
bool passes_close(GridPoint a, GridPoint b, GridPoint p) {
  const auto [west, east] = std::minmax(a.x, b.x);
  const auto [south, north] = std::minmax(a.y, b.y);
  if (p.x < west - 1 || p.x > east + 1 || p.y < south - 1 || p.y > north + 1) return false;
  return 2 * std::abs(turn(a, b, p)) <= east - west + north - south;
}

bool is_in_closed_triangle(const std::array<GridPoint, 3>& corners, GridPoint p) {
  const std::int64_t area = turn(corners[0], corners[1], corners[2]);
  if (area == 0) return false;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t side = turn(corners[i], corners[(i + 1) % 3], p);
    if (area > 0 ? side < 0 : side > 0) return false;
  }
  return true;
}

// Andrew's monotone chain (1979).
std::vector<GridPoint> convex_hull(std::vector<GridPoint> points) {
  sort_unique(points);
  if (points.size() < 3) return points;
  std::vector<GridPoint> hull;
  const auto add = [&](GridPoint p, std::size_t least) {
    while (hull.size() > least && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
    hull.push_back(p);
  };
  for (const GridPoint p : points) add(p, 1);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

// A border in its current form, and the convex hull of all it replaces.
struct Run {
  std::uint32_t from, to;  // vertices
  std::uint32_t left, right;
  bool is_cell_border;
  bool is_gone = false;
  double error = 0;             // grid steps
  std::vector<GridPoint> hull;  // empty while it replaces only itself: then its two ends are the hull

  std::uint32_t beyond(std::uint32_t end) const { return end == from ? to : from; }
  void turn_round() {
    std::swap(from, to);
    std::swap(left, right);
  }
};

// A blocked vertex and the number of its look then.
struct BlockedVertex {
  std::uint32_t vertex, look;
};

// The network of borders during simplification. Vertices are sorted by place, so their numbers do not depend on the
// input's order.
struct Net {
  std::vector<GridPoint> vertices;
  std::vector<Run> runs;
  std::vector<std::uint32_t> starts, incident;  // per vertex the runs that end there
  std::vector<bool> may_go, is_gone;
  std::vector<std::uint32_t> looks;                     // how often each vertex was looked at; earlier looks are stale
  std::vector<std::vector<BlockedVertex>> waiting_for;  // per vertex those that it blocks
  PointBuckets buckets;
  double tolerance = 0;  // grid steps

  std::span<std::uint32_t> runs_at(std::uint32_t v) {
    return std::span(incident).subspan(starts[v], starts[v + 1] - starts[v]);
  }
};

// A vertex that may be removed, and the error that its removal would make.
struct VertexRemoval {
  double error;
  std::uint32_t vertex, look;
  bool operator<(const VertexRemoval& o) const { return std::tie(error, vertex) > std::tie(o.error, o.vertex); }
};
using Queue = std::priority_queue<VertexRemoval>;

void link_runs(Net& net) {
  net.starts.assign(net.vertices.size() + 1, 0);
  for (const Run& run : net.runs) ++net.starts[run.from + 1], ++net.starts[run.to + 1];
  for (std::size_t v = 1; v < net.starts.size(); ++v) net.starts[v] += net.starts[v - 1];
  net.incident.resize(2 * net.runs.size());
  std::vector<std::uint32_t> next(net.starts.begin(), net.starts.end() - 1);
  for (std::uint32_t r = 0; r < net.runs.size(); ++r)
    for (const std::uint32_t end : {net.runs[r].from, net.runs[r].to}) net.incident[next[end]++] = r;
}

// Returns whether exactly two inner borders meet here, with the same polygons on both sides.
bool is_midway(Net& net, std::uint32_t v) {
  const auto at = net.runs_at(v);
  if (at.size() != 2) return false;
  const Run& one = net.runs[at[0]];
  const Run& other = net.runs[at[1]];
  const bool runs_on = (one.to == v) == (other.from == v);
  return !one.is_cell_border && !other.is_cell_border && one.left == (runs_on ? other.left : other.right) &&
         one.right == (runs_on ? other.right : other.left);
}

Net net_of(std::span<const Border> borders, double tolerance_m, const std::function<bool(GridPoint)>& is_pinned) {
  Net net;
  net.vertices = ends_of(borders);
  const auto number = [&](GridPoint p) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(net.vertices, p) - net.vertices.begin());
  };
  for (const Border& b : borders)
    net.runs.push_back({number(b.a), number(b.b), b.left, b.right, b.is_cell_border, false, 0, {}});
  link_runs(net);
  GridPoint min = net.vertices.front(), max = min;
  for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
    const GridPoint p = net.vertices[v];
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    net.may_go.push_back(is_midway(net, v) && !is_pinned(p));
  }
  net.is_gone.assign(net.vertices.size(), false);
  net.looks.assign(net.vertices.size(), 0);
  net.waiting_for.resize(net.vertices.size());
  net.buckets = bucket_points(net.vertices, min, max);
  net.tolerance = tolerance_m / kQuantum_m;
  return net;
}

// Returns the other ends of the two borders at a vertex.
std::array<std::uint32_t, 2> neighbours(Net& net, std::uint32_t v) {
  const auto at = net.runs_at(v);
  return {net.runs[at[0]].beyond(v), net.runs[at[1]].beyond(v)};
}

bool are_joined(Net& net, std::uint32_t a, std::uint32_t b) {
  return std::ranges::any_of(net.runs_at(a), [&](std::uint32_t r) { return net.runs[r].beyond(a) == b; });
}

// Visits the corners of the run's hull.
template <typename Visit>
void for_each_corner(const Net& net, const Run& run, Visit visit) {
  if (run.hull.empty()) visit(net.vertices[run.from]), visit(net.vertices[run.to]);
  for (const GridPoint p : run.hull) visit(p);
}

double error_without(Net& net, std::uint32_t v) {
  const auto [a, b] = neighbours(net, v);
  const GridPoint from = net.vertices[a], to = net.vertices[b];
  double error = 0;
  for (const std::uint32_t r : net.runs_at(v))
    for_each_corner(net, net.runs[r], [&](GridPoint p) { error = std::max(error, distance_to_segment(from, to, p)); });
  return error;
}

constexpr std::uint32_t kNoBlocker = 0xffffffffu;

// Returns a vertex in the way of the edge that would replace v's two borders.
std::uint32_t blocker_of(Net& net, std::uint32_t v) {
  const auto ends = neighbours(net, v);
  const std::array<GridPoint, 3> corners = {net.vertices[ends[0]], net.vertices[v], net.vertices[ends[1]]};
  std::uint32_t blocker = kNoBlocker;
  any_near_triangle(net.buckets, corners, [&](std::uint32_t u) {
    if (u == v || u == ends[0] || u == ends[1]) return false;
    const GridPoint p = net.vertices[u];
    if (is_in_closed_triangle(corners, p) || passes_close(corners[0], corners[2], p)) blocker = u;
    return blocker != kNoBlocker;
  });
  return blocker;
}

// Queues a vertex that may be removed, or lets it wait for the vertex that blocks it.
void look_at(Net& net, Queue& queue, std::uint32_t v) {
  if (!net.may_go[v] || net.is_gone[v]) return;
  const std::uint32_t look = ++net.looks[v];
  const double error = error_without(net, v);
  if (error > net.tolerance) return;
  const std::uint32_t blocker = blocker_of(net, v);
  if (blocker == kNoBlocker)
    queue.push({error, v, look});
  else
    net.waiting_for[blocker].push_back({v, look});
}

// Joins the two runs at a vertex into the first of them.
void leave_out(Net& net, std::uint32_t v, double error) {
  const std::uint32_t kept = net.runs_at(v)[0], lost = net.runs_at(v)[1];
  Run& run = net.runs[kept];
  Run& other = net.runs[lost];
  std::vector<GridPoint> corners;
  for (const Run* one : {&run, &other}) for_each_corner(net, *one, [&](GridPoint p) { corners.push_back(p); });
  if (run.from == v) run.turn_round();
  run.to = other.beyond(v);
  run.error = error;
  run.hull = convex_hull(std::move(corners));
  other.is_gone = true;
  other.hull.clear();
  std::ranges::replace(net.runs_at(run.to), lost, kept);
  net.is_gone[v] = true;
  remove_point(net.buckets, v, net.vertices[v]);
}

SimplifiedBorders borders_of(const Net& net) {
  SimplifiedBorders simplified;
  for (Run run : net.runs) {
    if (run.is_gone) continue;
    if (run.to < run.from) run.turn_round();
    simplified.borders.push_back(
        {net.vertices[run.from], net.vertices[run.to], run.left, run.right, run.is_cell_border});
    simplified.error_m = std::max(simplified.error_m, run.error * kQuantum_m);
  }
  std::ranges::sort(simplified.borders, is_before);
  return simplified;
}

}  // namespace

SimplifiedBorders simplify_borders(std::span<const Border> borders, double tolerance_m,
                                   const std::function<bool(GridPoint)>& is_pinned) {
  assert(tolerance_m >= 0);
  if (borders.empty()) return {};
  Net net = net_of(borders, tolerance_m, is_pinned);
  Queue queue;
  for (std::uint32_t v = 0; v < net.vertices.size(); ++v) look_at(net, queue, v);
  while (!queue.empty()) {
    const VertexRemoval least = queue.top();
    queue.pop();
    const std::uint32_t v = least.vertex;
    if (net.is_gone[v] || net.looks[v] != least.look) continue;
    const auto [a, b] = neighbours(net, v);
    // a ring keeps three vertices, and two borders with the same ends stay two
    if (are_joined(net, a, b)) continue;
    leave_out(net, v, least.error);
    look_at(net, queue, a);
    look_at(net, queue, b);
    for (const BlockedVertex& waiting : net.waiting_for[v])
      if (net.looks[waiting.vertex] == waiting.look) look_at(net, queue, waiting.vertex);
  }
  return borders_of(net);
}

}  // namespace citykiln::ground

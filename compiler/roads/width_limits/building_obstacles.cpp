#include "compiler/roads/width_limits/building_obstacles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/geometry/segment.h"

namespace citykiln::roads {
namespace {

bool obstructs(const map::Footprint& footprint) {
  return !footprint.is_open && !footprint.has_parts && footprint.min_height_m < kHeadroom_m;
}

std::int32_t step_below(double along_m) { return static_cast<std::int32_t>(std::floor(along_m / kStep_m)); }

// State while a road's obstacles are collected.
struct ObstacleSearch {
  const Road& road;
  std::vector<double> along_m;  // distances of the vertices
  double middle_m;              // middle of the carriageway, left of the axis, before it drifts
  double left_m, right_m;       // from the middle of the carriageway to the outer edges
  BuildingObstacles found;
};

double middle_at(const ObstacleSearch& search, double along_m) {
  return search.middle_m + drift_m(search.road, along_m);
}

// A closed range of steps.
struct Steps {
  std::int32_t from, to;
};

struct Edge {
  Vec2 a, b;
};

// The part of an edge where a linear function is not negative, given its values at the ends.
std::optional<Edge> clipped(const Edge& edge, double fa, double fb) {
  if (fa < 0 && fb < 0) return std::nullopt;
  if (fa >= 0 && fb >= 0) return edge;
  const Vec2 cut = edge.a + (edge.b - edge.a) * (fa / (fa - fb));
  return fa < 0 ? Edge{cut, edge.b} : Edge{edge.a, cut};
}

void add_obstacle(ObstacleSearch& search, std::span<const Steps> passages, std::int32_t step, double half_m,
                  bool is_left) {
  if (half_m >= (is_left ? search.left_m : search.right_m)) return;
  const auto is_inside = [&](Steps s) { return s.from <= step && step <= s.to; };
  if (std::ranges::any_of(passages, is_inside)) return search.found.covered.push_back(step);
  const double units = std::floor(half_m / kUnit_m);
  search.found.obstacles.push_back({step, static_cast<std::int16_t>(units), is_left});
}

// Adds the obstacles of an edge with x along the way and y from the middle, y of one sign: each step takes the nearest
// part of the edge within one step.
void add_edge(ObstacleSearch& search, std::span<const Steps> passages, Edge edge, bool is_left) {
  if (edge.b.x < edge.a.x) std::swap(edge.a, edge.b);
  const auto y_at = [&](double x) {
    return x <= edge.a.x   ? edge.a.y
           : x >= edge.b.x ? edge.b.y
                           : edge.a.y + (edge.b.y - edge.a.y) * ((x - edge.a.x) / (edge.b.x - edge.a.x));
  };
  for (std::int32_t step = step_below(edge.a.x); step <= step_below(edge.b.x); ++step) {
    const bool is_across = edge.a.x == edge.b.x;
    const double from = is_across ? edge.a.y : y_at(step * kStep_m),
                 to = is_across ? edge.b.y : y_at((step + 1) * kStep_m);
    const double half = std::min(std::abs(from), std::abs(to));
    add_obstacle(search, passages, step, half, is_left);
    add_obstacle(search, passages, step + 1, half, is_left);
  }
}

// Adds what a footprint's edge leaves of the quad beside a segment.
void add_beside_segment(ObstacleSearch& search, std::span<const Steps> passages, std::size_t segment,
                        const Edge& wall) {
  const Vec2 origin = search.road.axis[segment], along = search.road.axis[segment + 1] - origin;
  const double length_m = length(along), begin_m = search.along_m[segment];
  const double stretch = (search.along_m[segment + 1] - begin_m) / length_m;
  const auto in_frame = [&](Vec2 p) {
    const double x = dot(p - origin, along) / length_m;
    return Vec2{x, cross(along, p - origin) / length_m - middle_at(search, begin_m + x * stretch)};
  };
  std::optional<Edge> edge = Edge{in_frame(wall.a), in_frame(wall.b)};
  if (std::min(edge->a.y, edge->b.y) >= search.left_m || std::max(edge->a.y, edge->b.y) <= -search.right_m) return;
  edge = clipped(*edge, edge->a.x, edge->b.x);
  if (edge) edge = clipped(*edge, length_m - edge->a.x, length_m - edge->b.x);
  if (!edge) return;
  for (Vec2* p : {&edge->a, &edge->b}) p->x = begin_m + p->x * stretch;
  if (const auto left = clipped(*edge, edge->a.y, edge->b.y)) add_edge(search, passages, *left, true);
  if (const auto right = clipped(*edge, -edge->a.y, -edge->b.y)) add_edge(search, passages, *right, false);
}

// The smallest half width whose mitre touches an edge: the minimum along the edge of the larger of two linear
// functions.
double least_of_larger(double f_a, double f_b, double g_a, double g_b) {
  const double at_a = std::max(f_a, g_a), at_b = std::max(f_b, g_b), before = f_a - g_a, after = f_b - g_b;
  double least = std::min(at_a, at_b);
  if ((before < 0) != (after < 0)) least = std::min(least, f_a + (f_b - f_a) * (before / (before - after)));
  return least;
}

void add_at(ObstacleSearch& search, std::span<const Steps> passages, double along_m, double half_m, bool is_left) {
  const double middle_m = middle_at(search, along_m);
  const double from_middle = std::max(0.0, is_left ? half_m - middle_m : half_m + middle_m);
  add_obstacle(search, passages, step_below(along_m), from_middle, is_left);
  add_obstacle(search, passages, step_below(along_m) + 1, from_middle, is_left);
}

// Adds what a footprint's edge leaves of the corner that a bend opens: a mitre, or a disk where the bend is sharp.
void add_beside_bend(ObstacleSearch& search, std::span<const Steps> passages, Vec2 at, double along_m, Vec2 before,
                     Vec2 after, const Edge& wall) {
  if (dot(before, after) <= 0) {
    const double half = distance_to_segment(wall.a, wall.b, at);
    add_at(search, passages, along_m, half, true), add_at(search, passages, along_m, half, false);
    return;
  }
  std::optional<Edge> edge = Edge{wall.a - at, wall.b - at};
  edge = clipped(*edge, dot(edge->a, before), dot(edge->b, before));
  if (edge) edge = clipped(*edge, -dot(edge->a, after), -dot(edge->b, after));
  if (!edge) return;
  const bool is_left = cross(before, after) < 0;
  const double side = is_left ? 1 : -1;
  const auto out = [&](Vec2 direction, Vec2 p) { return side * cross(direction, p); };
  const double half =
      least_of_larger(out(before, edge->a), out(before, edge->b), out(after, edge->a), out(after, edge->b));
  if (half >= 0) add_at(search, passages, along_m, half, is_left);
}

void add_beside(ObstacleSearch& search, std::span<const Steps> passages, std::size_t segment, const StripEnds& ends,
                const Edge& wall) {
  const Polyline& axis = search.road.axis;
  add_beside_segment(search, passages, segment, wall);
  const Vec2 along = unit(axis[segment + 1] - axis[segment]);
  const auto bend = [&](std::size_t v, Vec2 before, Vec2 after) {
    add_beside_bend(search, passages, axis[v], search.along_m[v], before, after, wall);
  };
  const bool is_joined = ends.before && dot(axis[0] - *ends.before, along) > 0;
  if (segment > 0) bend(segment, unit(axis[segment] - axis[segment - 1]), along);
  if (segment == 0 && is_joined) bend(0, unit(axis[0] - *ends.before), along);
  const std::size_t last = axis.size() - 1;
  if (segment + 1 == last && ends.after && dot(*ends.after - axis[last], along) > 0)
    bend(last, along, unit(*ends.after - axis[last]));
}

template <typename Visit>
void for_each_wall(const Polygon& polygon, Visit visit) {
  const auto walk = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) visit(Edge{ring[j], ring[i]});
  };
  walk(polygon.outer);
  for (const Ring& hole : polygon.holes) walk(hole);
}

// Adds the shares of a segment at which it meets a wall; touching counts.
void add_meetings(const Edge& segment, const Edge& wall, std::vector<double>& shares) {
  const Vec2 along = segment.b - segment.a;
  const double da = cross(along, wall.a - segment.a), db = cross(along, wall.b - segment.a);
  if ((da > 0 && db > 0) || (da < 0 && db < 0)) return;
  const auto share_at = [&](Vec2 p) { return dot(p - segment.a, along) / dot(along, along); };
  if (da == 0 && db == 0) {
    const auto [from, to] = std::minmax({share_at(wall.a), share_at(wall.b)});
    if (from <= 1 && to >= 0) shares.push_back(std::max(from, 0.0)), shares.push_back(std::min(to, 1.0));
    return;
  }
  const double share = share_at(wall.a + (wall.b - wall.a) * (da / (da - db)));
  // a shared node can come out one rounding beyond the end
  constexpr double kRounding = 0x1p-30;
  if (share >= -kRounding && share <= 1 + kRounding) shares.push_back(std::clamp(share, 0.0, 1.0));
}

// Adds the ranges, widened by kPassage_m, where the axis runs into or through a footprint.
void find_passages(ObstacleSearch& search, std::size_t segment, const Polygon& footprint,
                   std::vector<Steps>& passages) {
  const Edge axis{search.road.axis[segment], search.road.axis[segment + 1]};
  const Box2 box = box_of_segment(axis.a, axis.b);
  if (!box.touches(box_of(footprint.outer))) return;
  const double from_m = search.along_m[segment], length_m = search.along_m[segment + 1] - from_m;
  constexpr auto kSteps = static_cast<std::int32_t>(kPassage_m / kStep_m);
  const auto step_at = [&](double share) { return step_below(from_m + share * length_m); };
  std::vector<double> shares;
  for_each_wall(footprint, [&](const Edge& wall) { add_meetings(axis, wall, shares); });
  for (const double share : shares) passages.push_back({step_at(share) - kSteps, step_at(share) + 1 + kSteps});
  shares.push_back(0), shares.push_back(1);
  std::sort(shares.begin(), shares.end());
  for (std::size_t i = 1; i < shares.size(); ++i) {
    if (shares[i] == shares[i - 1]) continue;
    if (!contains(footprint, axis.a + (axis.b - axis.a) * ((shares[i] + shares[i - 1]) / 2))) continue;
    const Steps inside{step_at(shares[i - 1]), step_at(shares[i])};
    passages.push_back({inside.from - kSteps, inside.to + 1 + kSteps});
    for (std::int32_t step = inside.from; step < inside.to; ++step) search.found.covered.push_back(step);
  }
}

// The pairs of footprint and segment that come near each other, sorted by footprint.
std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_near(const Road& road,
                                                                const ObstructingFootprints& footprints) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const double reach_m = max_offset_m(road);
  for (std::uint32_t segment = 0; segment + 1 < road.axis.size(); ++segment) {
    const Box2 box = box_of_segment(road.axis[segment], road.axis[segment + 1]).widened(reach_m);
    for (const std::uint32_t footprint : footprints.near(box)) pairs.emplace_back(footprint, segment);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

ObstructingFootprints::ObstructingFootprints(std::span<const map::Footprint> footprints) : footprints_(footprints) {
  constexpr double kBucket_m = 32;
  for (std::uint32_t i = 0; i < footprints.size(); ++i)
    if (obstructs(footprints[i])) indices_.push_back(i), boxes_.push_back(box_of(footprints[i].polygon.outer));
  grid_ = grid_of(boxes_, kBucket_m);
}

std::vector<std::uint32_t> ObstructingFootprints::near(const Box2& box) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t i : boxes_about(grid_, box))
    if (boxes_[i].touches(box)) found.push_back(indices_[i]);
  return found;
}

BuildingObstacles find_building_obstacles(const Road& road, const StripEnds& ends,
                                          const ObstructingFootprints& footprints) {
  assert(road.axis.size() >= 2);
  const double kerb_left = left_m(road), kerb_right = right_m(road), half = (kerb_left + kerb_right) / 2;
  ObstacleSearch search{road,
                        distances_along(road),
                        (kerb_left - kerb_right) / 2,
                        half + raised_left_m(road),
                        half + raised_right_m(road),
                        {}};
  const auto pairs = pairs_near(road, footprints);
  const double reach_m = max_offset_m(road);
  std::vector<Steps> passages;
  for (std::size_t i = 0, end = 0; i < pairs.size(); i = end) {
    const Polygon& footprint = footprints[pairs[i].first];
    passages.clear();
    for (end = i; end < pairs.size() && pairs[end].first == pairs[i].first; ++end)
      find_passages(search, pairs[end].second, footprint, passages);
    for (std::size_t pair = i; pair < end; ++pair) {
      const std::uint32_t segment = pairs[pair].second;
      const Box2 box = box_of_segment(road.axis[segment], road.axis[segment + 1]).widened(reach_m);
      for_each_wall(footprint, [&](const Edge& wall) {
        if (box_of_segment(wall.a, wall.b).touches(box)) add_beside(search, passages, segment, ends, wall);
      });
    }
  }
  std::vector<std::int32_t>& covered = search.found.covered;
  std::sort(covered.begin(), covered.end());
  covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
  return std::move(search.found);
}

}  // namespace citykiln::roads

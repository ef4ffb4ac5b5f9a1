#include "compiler/parcels/field.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/box_grid.h"

namespace citykiln::parcels {
namespace {

constexpr double kObstacleBucket_m = 32;

bool cross_within(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double s = twice_area(a, b, c), t = twice_area(a, b, d);
  if ((s > 0) == (t > 0)) return false;
  const double u = twice_area(c, d, a), v = twice_area(c, d, b);
  return (u > 0) != (v > 0);
}

}  // namespace

Obstacles obstacles_of(const std::vector<Line>& lines, const std::vector<Polygon>& taken) {
  Obstacles obstacles;
  for (const Line& line : lines)
    for (std::size_t i = 0; line.kind != LineKind::kNone && i + 1 < line.axis.size(); ++i)
      obstacles.segments.emplace_back(line.axis[i], line.axis[i + 1]);
  for (const Polygon& polygon : taken)
    for (const Ring* ring : rings_of(polygon))
      for (std::size_t i = 0, j = ring->size() - 1; i < ring->size(); j = i++)
        obstacles.segments.emplace_back((*ring)[j], (*ring)[i]);
  std::vector<Box2> boxes;
  for (const auto& [a, b] : obstacles.segments) boxes.push_back(box_of_segment(a, b));
  obstacles.grid = grid_of(boxes, kObstacleBucket_m);
  return obstacles;
}

bool is_seen(const Obstacles& obstacles, Vec2 a, Vec2 b) {
  return !any_about(obstacles.grid, box_of_segment(a, b), [&](std::uint32_t i) {
    return cross_within(a, b, obstacles.segments[i].first, obstacles.segments[i].second);
  });
}

double distance_to_obstacle(const Obstacles& obstacles, Vec2 p, Vec2 towards, double most_m) {
  double least = most_m;
  const Vec2 end = p + towards * most_m;
  any_about(obstacles.grid, box_of_segment(p, end), [&](std::uint32_t i) {
    const auto& [c, d] = obstacles.segments[i];
    if (cross_within(p, end, c, d)) least = std::min(least, cross(c - p, d - c) / cross(towards, d - c));
    return false;
  });
  return least;
}

namespace {

// Small enough that a bucket has few pieces in dense towns.
constexpr double kPieceBucket_m = 32;
// A wedge's distance is too small by at most 1 - cos(15°), 3.4 %.
constexpr double kWedgeCosine = 0.866;

// False only if an edge of a convex counter-clockwise ring has the whole box on its outer side.
bool touches(std::span<const Vec2> ring, const Box2& box) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 edge = ring[i] - ring[j];
    const Vec2 innermost{edge.y < 0 ? box.max.x : box.min.x, edge.x > 0 ? box.max.y : box.min.y};
    if (twice_area(ring[j], ring[i], innermost) < 0) return false;
  }
  return true;
}

Vec2 foot_of(const Piece& piece, Vec2 p) { return piece.foot + piece.along * dot(p - piece.foot, piece.along); }

// Tries candidates in the order of distance until one is seen.
template <typename IsIn>
std::uint32_t nearest_seen(const Field& field, std::span<const std::uint32_t> candidates, Vec2 p, double most_m,
                           IsIn is_in) {
  double after = -1;
  std::uint32_t after_index = 0;
  for (;;) {
    double least = most_m;
    std::uint32_t best = kNoIndex;
    for (const std::uint32_t i : candidates) {
      const Piece& piece = field.pieces[i];
      const double d = distance_m(piece, p);
      if (d >= least || d < after || (d == after && i <= after_index)) continue;
      if (!is_in(piece) || !is_in_convex(piece.land, p)) continue;
      least = d, best = i;
    }
    if (best == kNoIndex || is_seen(*field.obstacles, p, foot_of(field.pieces[best], p))) return best;
    after = least, after_index = best;
  }
}

void add_wedge(std::vector<Piece>& pieces, Vec2 tip, Vec2 from, Vec2 to, double depth_m, std::uint32_t street_edge,
               std::uint32_t label) {
  if (dot(from, to) < kWedgeCosine) {
    const Vec2 sum = from + to;
    const Vec2 middle = dot(sum, sum) > 1e-6 ? unit(sum) : left_of(from) * -1;
    add_wedge(pieces, tip, from, middle, depth_m, street_edge, label);
    add_wedge(pieces, tip, middle, to, depth_m, street_edge, label);
    return;
  }
  if (cross(from, to) > -1e-6) return;
  pieces.push_back({tip, unit(from + to), {}, {tip, tip + to * depth_m, tip + from * depth_m}, street_edge, label});
}

}  // namespace

Field field_of(std::vector<Piece> pieces, const Obstacles& obstacles) {
  Field field{std::move(pieces), {}, &obstacles};
  std::vector<Box2> boxes;
  for (const Piece& piece : field.pieces) boxes.push_back(box_of(piece.land));
  field.grid = grid_of(boxes, kPieceBucket_m,
                       [&](std::uint32_t i, const Box2& bucket) { return touches(field.pieces[i].land, bucket); });
  return field;
}

void add_piece(std::vector<Piece>& pieces, const RightsOfWay& ways, std::uint32_t street_edge, double from_m,
               double to_m, double depth_m, std::uint32_t label) {
  const RightOfWayEdge& f = ways.street_edges[street_edge];
  const Vec2 along = unit(f.b - f.a);
  const Vec2 a = from_m <= 0 ? f.a : f.a + along * from_m, b = to_m >= f.length_m() ? f.b : f.a + along * to_m;
  if (a == b || depth_m <= 0) return;
  pieces.push_back({a, f.normal, along, {a, b, b + f.normal * depth_m, a + f.normal * depth_m}, street_edge, label});
}

void add_wedges(std::vector<Piece>& pieces, const RightsOfWay& ways, std::uint32_t street_edge, double depth_m,
                std::uint32_t label) {
  const RightOfWayEdge& f = ways.street_edges[street_edge];
  if (!f.turns_outward || f.next == kNoIndex || depth_m <= 0) return;
  add_wedge(pieces, f.b, f.normal, ways.street_edges[f.next].normal, depth_m, street_edge, label);
}

bool is_seen_by(const Field& field, const Piece& piece, Vec2 p) {
  return is_seen(*field.obstacles, p, foot_of(piece, p));
}

std::uint32_t nearest_piece(const Field& field, Vec2 p) { return nearest_piece(field, boxes_about(field.grid, p), p); }

std::uint32_t nearest_piece(const Field& field, std::span<const std::uint32_t> pieces, Vec2 p) {
  return nearest_seen(field, pieces, p, 4 * kDepth_m, [](const Piece&) { return true; });
}

bool is_any_nearer(const Field& field, std::span<const std::uint32_t> pieces, Vec2 p, double below_m) {
  return std::ranges::any_of(pieces, [&](std::uint32_t i) {
    const Piece& piece = field.pieces[i];
    const double d = distance_m(piece, p);
    return d >= 0 && d < below_m && is_in_convex(piece.land, p) && is_seen_by(field, piece, p);
  });
}

std::uint32_t nearest_other(const Field& field, Vec2 p, std::uint32_t street_edge, double most_m) {
  return nearest_seen(field, boxes_about(field.grid, p), p, most_m,
                      [&](const Piece& piece) { return piece.street_edge != street_edge; });
}

}  // namespace citykiln::parcels

#include "compiler/parcels/obstacles.h"

#include <algorithm>

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

}  // namespace citykiln::parcels

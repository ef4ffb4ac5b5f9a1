#include "compiler/props/drape_line.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::props {
namespace {

// Parallel grid lines: level sets of a linear function for the values start, start + step, … (count of them).
struct GridLines {
  double start, step;
  int count;
};

// Adds the shares of a segment at which the function, `from` at its begin and `to` at its end, has a grid line's value.
void add_crossings(double from, double to, const GridLines& lines, std::vector<double>& shares) {
  if (from == to) return;
  const double low = std::min(from, to), high = std::max(from, to);
  const double first = std::max(0.0, std::ceil((low - lines.start) / lines.step));
  for (double i = first; i < lines.count && lines.start + i * lines.step <= high; ++i)
    shares.push_back((lines.start + i * lines.step - from) / (to - from));
}

// Adds where the segment crosses columns, rows and diagonals of the terrain's grid.
void add_grid_crossings(Vec2 a, Vec2 b, const map::Heightfield& terrain, std::vector<double>& shares) {
  add_crossings(a.x, b.x, {terrain.min.x, terrain.step_m.x, terrain.columns}, shares);
  add_crossings(a.y, b.y, {terrain.min.y, terrain.step_m.y, terrain.rows}, shares);
  // the cross product with the diagonal from south-west to north-east is constant on each diagonal, and least in the
  // north-west
  const auto diagonal = [&](Vec2 p) { return cross(p, terrain.step_m); };
  const GridLines diagonals{diagonal(terrain.vertex(0, terrain.rows - 1)), terrain.step_m.x * terrain.step_m.y,
                            terrain.columns + terrain.rows - 1};
  add_crossings(diagonal(a), diagonal(b), diagonals, shares);
}

// Cuttings and embankments are a few metres wide.
constexpr double kGradingStep_m = 2;

std::vector<double> bends(Vec2 a, Vec2 b, const ground::GradedTerrain& ground) {
  std::vector<double> shares;
  add_grid_crossings(a, b, ground.terrain, shares);
  const bool has_grading = ground::has_grading(ground, box_of_segment(a, b));
  const double steps = has_grading ? std::ceil(distance(a, b) / kGradingStep_m) : 1;
  for (double i = 1; i < steps; ++i) shares.push_back(i / steps);
  std::sort(shares.begin(), shares.end());
  return shares;
}

// Marks the points to keep between `first` and `last`.
void keep_bends(const std::vector<Vec3>& line, double bend_m, std::size_t first, std::size_t last,
                std::vector<bool>& kept) {
  std::size_t farthest = first;
  double farthest_m = bend_m;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double off_m = distance_to_segment(line[first], line[last], line[i]);
    if (off_m > farthest_m) farthest_m = off_m, farthest = i;
  }
  if (farthest == first) return;
  kept[farthest] = true;
  keep_bends(line, bend_m, first, farthest, kept), keep_bends(line, bend_m, farthest, last, kept);
}

}  // namespace

std::vector<Vec3> drape_line(const Polyline& line, const ground::GradedTerrain& ground) {
  std::vector<Vec3> points;
  const auto push = [&](Vec2 p) {
    if (points.empty() || in_plan(points.back()) != p) points.push_back(at_height(p, snapped(land_m(ground, p))));
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0)
      for (const double share : bends(line[i - 1], line[i], ground))
        push(snapped(line[i - 1] + (line[i] - line[i - 1]) * share));
    push(line[i]);
  }
  return points;
}

std::vector<Vec3> without_small_bends(const std::vector<Vec3>& line, double bend_m) {
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size());
  kept.front() = kept.back() = true;
  keep_bends(line, bend_m, 0, line.size() - 1, kept);
  std::vector<Vec3> bends;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) bends.push_back(line[i]);
  return bends;
}

Vec2 mitred_side(const std::vector<Vec3>& line, std::size_t i, bool is_closed) {
  assert(line.size() >= 2 && i < line.size());
  // in multiples of half the width
  constexpr double kMaxMitre = 2;
  const std::size_t last = line.size() - 1;
  const auto direction = [&](std::size_t a) { return unit(in_plan(line[a + 1] - line[a])); };
  const Vec2 before = direction(i > 0       ? i - 1
                                : is_closed ? last - 1
                                            : 0),
             after = direction(i < last    ? i
                               : is_closed ? 0
                                           : last - 1);
  const Vec2 middle = unit(before + after);
  if (middle == Vec2{}) return left_of(before);
  return left_of(middle) * std::min(1 / std::max(dot(middle, before), 1e-9), kMaxMitre);
}

}  // namespace citykiln::props

#include "compiler/props/drape_line.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::props {
namespace {

// Parallel lines, on which a function of the place takes the values start, start + step … (count of them).
struct Family {
  double start, step;
  int count;
};

// Appends where, between 0 and 1, a value that runs evenly from `from` to `to` passes one of the family's.
void add_passages(double from, double to, const Family& lines, std::vector<double>& shares) {
  if (from == to) return;
  const double low = std::min(from, to), high = std::max(from, to);
  const double first = std::max(0.0, std::ceil((low - lines.start) / lines.step));
  for (double i = first; i < lines.count && lines.start + i * lines.step <= high; ++i)
    shares.push_back((lines.start + i * lines.step - from) / (to - from));
}

// Where the segment crosses columns, rows and diagonals of the field, sorted.
std::vector<double> crossings(Vec2 a, Vec2 b, const map::Heightfield& field) {
  std::vector<double> shares;
  add_passages(a.x, b.x, {field.min.x, field.step_m.x, field.columns}, shares);
  add_passages(a.y, b.y, {field.min.y, field.step_m.y, field.rows}, shares);
  // diagonals from south-west to north-east: a cross product with one is constant on each, least in the north-west
  const auto beside = [&](Vec2 p) { return cross(p, field.step_m); };
  const Family diagonals{beside(field.vertex(0, field.rows - 1)), field.step_m.x * field.step_m.y,
                         field.columns + field.rows - 1};
  add_passages(beside(a), beside(b), diagonals, shares);
  std::sort(shares.begin(), shares.end());
  return shares;
}

// Cuts and banks are a few metres wide.
constexpr double kCarvedStep_m = 2;

std::vector<double> bends(Vec2 a, Vec2 b, const ground::GradedTerrain& ground) {
  std::vector<double> shares = crossings(a, b, ground.terrain);
  const bool has_grading = ground::has_grading(ground, box_of(std::array{a, b}));
  const double steps = has_grading ? std::ceil(distance(a, b) / kCarvedStep_m) : 1;
  for (double i = 1; i < steps; ++i) shares.push_back(i / steps);
  std::sort(shares.begin(), shares.end());
  return shares;
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

}  // namespace citykiln::props

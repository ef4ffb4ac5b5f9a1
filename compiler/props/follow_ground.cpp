#include "compiler/props/follow_ground.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::props {
namespace {

// Appends where, between 0 and 1, a value that runs evenly from `from` to `to` passes one of the whole numbers 0 …
// last.
void add_passages(double from, double to, double last, std::vector<double>& shares) {
  if (from == to) return;
  const double first = std::max(0.0, std::ceil(std::min(from, to)));
  for (double line = first; line <= std::min(last, std::max(from, to)); ++line)
    shares.push_back((line - from) / (to - from));
}

// Where the segment crosses columns, rows and diagonals of the field, sorted.
std::vector<double> crossings(Vec2 a, Vec2 b, const map::Heightfield& field) {
  const Vec2 from = (a - field.min) * (1 / field.step_m), to = (b - field.min) * (1 / field.step_m);
  std::vector<double> shares;
  add_passages(from.x, to.x, field.columns - 1, shares);
  add_passages(from.y, to.y, field.rows - 1, shares);
  // diagonals from south-west to north-east: x - y is whole, and counted from the north-west corner not negative
  const double shift = field.rows - 1;
  add_passages(from.x - from.y + shift, to.x - to.y + shift, shift + field.columns - 1, shares);
  std::sort(shares.begin(), shares.end());
  return shares;
}

// Cuts and banks are a few metres wide.
constexpr double kCarvedStep_m = 2;

std::vector<double> bends(Vec2 a, Vec2 b, const ground::Carving& ground) {
  std::vector<double> shares = crossings(a, b, ground.terrain);
  const bool is_carved = ground::is_carved(ground, box_of(std::array{a, b}));
  const double steps = is_carved ? std::ceil(distance(a, b) / kCarvedStep_m) : 1;
  for (double i = 1; i < steps; ++i) shares.push_back(i / steps);
  std::sort(shares.begin(), shares.end());
  return shares;
}

}  // namespace

std::vector<Vec3> follow_ground(const Polyline& line, const ground::Carving& ground) {
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

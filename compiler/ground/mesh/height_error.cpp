#include "compiler/ground/mesh/height_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

// The whole steps strictly between two values, counted from `start`.
struct StepRange {
  int first, last;
};
StepRange steps_between(double low, double high, double start, double step) {
  return {static_cast<int>(std::floor((low - start) / step)) + 1,
          static_cast<int>(std::ceil((high - start) / step)) - 1};
}

// A family of parallel lines on which a linear function has the values start + k · step.
struct Family {
  double start, step;
  StepRange inside;
};

// Evaluates crossings with one family; value_a and value_b are the function's at the ends.
void consider_crossings(WorstPoint& worst, const map::Heightfield& terrain, Vec3 a, Vec3 b, double value_a,
                        double value_b, const Family& family) {
  if (value_a == value_b) return;
  const auto [start, step, inside] = family;
  const StepRange lines = steps_between(std::min(value_a, value_b), std::max(value_a, value_b), start, step);
  for (int k = std::max(lines.first, inside.first); k <= std::min(lines.last, inside.last); ++k) {
    const double t = (start + k * step - value_a) / (value_b - value_a);
    const Vec3 p = a + (b - a) * t;
    consider(worst, std::abs(p.z - map::height_m_at(terrain, in_plan(p))), in_plan(p));
  }
}

}  // namespace

WorstPoint worst_on_edge(const map::Heightfield& terrain, Vec3 a, Vec3 b) {
  WorstPoint worst;
  const Vec2 min = terrain.min, step = terrain.step_m;
  consider_crossings(worst, terrain, a, b, a.x, b.x, {min.x, step.x, {0, terrain.columns - 1}});
  consider_crossings(worst, terrain, a, b, a.y, b.y, {min.y, step.y, {0, terrain.rows - 1}});
  // the cross product with the diagonal is constant on each; exact, as its operands are whole multiples of the grid
  const auto beside = [&](Vec2 p) { return cross(p, step); };
  consider_crossings(worst, terrain, a, b, beside(in_plan(a)), beside(in_plan(b)),
                     {beside(min), step.x * step.y, {1 - terrain.rows, terrain.columns - 1}});
  return worst;
}

WorstPoint worst_on_cell_border(const map::Heightfield& terrain, Vec3 a, Vec3 b) {
  assert((a.x == b.x) != (a.y == b.y));
  if (in_plan(b) < in_plan(a)) std::swap(a, b);
  const bool by_x = a.x != b.x;
  const auto along_axis = [&](auto v) { return by_x ? v.x : v.y; };
  const auto across_axis = [&](auto v) { return by_x ? v.y : v.x; };
  const double low = along_axis(a), high = along_axis(b), start = along_axis(terrain.min);
  const double step = along_axis(terrain.step_m), other_step = across_axis(terrain.step_m);
  const double across = across_axis(a) - across_axis(terrain.min);
  // distance from a grid line to the nearest crossing of a diagonal beyond it
  const double beyond = snapped((across - std::floor(across / other_step) * other_step) * step / other_step);
  WorstPoint worst;
  const auto look_at = [&](double along) {
    if (along <= low || along >= high) return;
    const Vec2 p = by_x ? Vec2{along, a.y} : Vec2{a.x, along};
    if (!terrain.box().contains(p)) return;
    const double share = (along - low) / (high - low);
    consider(worst, std::abs(a.z + (b.z - a.z) * share - map::height_m_at(terrain, p)), p);
  };
  for (double line = start + std::floor((low - start) / step) * step; line < high; line += step) {
    look_at(line);
    if (beyond > 0) look_at(line + beyond);
  }
  return worst;
}

WorstPoint worst_inside(const map::Heightfield& terrain, const std::array<Vec3, 3>& corners) {
  assert(cross(in_plan(corners[1] - corners[0]), in_plan(corners[2] - corners[0])) > 0);
  WorstPoint worst;
  const auto [low_x, high_x] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [low_y, high_y] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const StepRange columns = steps_between(low_x, high_x, terrain.min.x, terrain.step_m.x);
  const StepRange rows = steps_between(low_y, high_y, terrain.min.y, terrain.step_m.y);
  const Vec2 u = in_plan(corners[1] - corners[0]), v = in_plan(corners[2] - corners[0]);
  const double area = cross(u, v);
  for (int j = std::max(rows.first, 0); j <= std::min(rows.last, terrain.rows - 1); ++j)
    for (int i = std::max(columns.first, 0); i <= std::min(columns.last, terrain.columns - 1); ++i) {
      const Vec2 p = terrain.vertex(i, j);
      const Vec2 w = p - in_plan(corners[0]);
      const double s = cross(w, v) / area, t = cross(u, w) / area;
      if (s < 0 || t < 0 || s + t > 1) continue;
      const double z = corners[0].z + s * (corners[1].z - corners[0].z) + t * (corners[2].z - corners[0].z);
      consider(worst, std::abs(z - terrain.height_m_at_vertex(i, j)), p);
    }
  return worst;
}

}  // namespace citykiln::ground

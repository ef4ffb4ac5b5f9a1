#include "compiler/map/plane/heightfield.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::map {
namespace {

// The cell of the grid lines start + i · step that holds a value, and the position in it, 0 to 1.
struct Between {
  int first;
  double share;
};

Between between_lines(double value, double start, double step, int count) {
  const double inside = std::clamp(value, start, start + (count - 1) * step);
  int i = std::min(static_cast<int>((inside - start) / step), count - 2);
  // the quotient is rounded, the grid lines are exact
  if (inside < start + i * step)
    --i;
  else if (i < count - 2 && inside >= start + (i + 1) * step)
    ++i;
  return {i, (inside - (start + i * step)) / step};
}

// The surface's gradient normal at a vertex by central differences, one-sided on the border.
Vec3 slope_normal(const Heightfield& field, int i, int j) {
  const int west = std::max(i - 1, 0), east = std::min(i + 1, field.columns - 1);
  const int south = std::max(j - 1, 0), north = std::min(j + 1, field.rows - 1);
  const double dx =
      (field.height_m_at_vertex(east, j) - field.height_m_at_vertex(west, j)) / ((east - west) * field.step_m.x);
  const double dy =
      (field.height_m_at_vertex(i, north) - field.height_m_at_vertex(i, south)) / ((north - south) * field.step_m.y);
  return unit(Vec3{-dx, -dy, 1});
}

// Lines of a grid.
struct Lines {
  int first, last;
};

// The grid lines start + i · step, of which every parts-th goes through samples.
struct Axis {
  double start, step;
  int count, parts;
};

// The lines of samples about a range and, for normals, one more line on either side.
Lines window_along(double low, double high, const Axis& axis) {
  const auto line = [&](double rounded_share) {
    return static_cast<int>(std::clamp(rounded_share, -2.0, axis.count + 1.0));
  };
  const int first = std::clamp(line(std::floor((low - axis.start) / axis.step)) - 1, 0, axis.count - 2);
  const int last = std::clamp(line(std::ceil((high - axis.start) / axis.step)) + 1, 1, axis.count - 1);
  const int first_sample = first / axis.parts;
  const int last_sample = std::max(first_sample + 1, (last + axis.parts - 1) / axis.parts);
  return {first_sample * axis.parts, last_sample * axis.parts};
}

std::vector<std::int32_t> part_of_grid(const std::vector<std::int32_t>& heights, int columns, Lines across,
                                       Lines along) {
  std::vector<std::int32_t> part;
  for (int j = along.first; j <= along.last; ++j) {
    const auto row = heights.begin() + static_cast<std::ptrdiff_t>(j) * columns;
    part.insert(part.end(), row + across.first, row + across.last + 1);
  }
  return part;
}

}  // namespace

CellPosition cell_at(const Heightfield& field, Vec2 p) {
  assert(field.columns >= 2 && field.rows >= 2);
  const Between x = between_lines(p.x, field.min.x, field.step_m.x, field.columns);
  const Between y = between_lines(p.y, field.min.y, field.step_m.y, field.rows);
  return {x.first, y.first, x.share, y.share};
}

double height_m_at(const Heightfield& field, Vec2 p) {
  const auto [i, j, u, v] = cell_at(field, p);
  const double sw = field.height_m_at_vertex(i, j), ne = field.height_m_at_vertex(i + 1, j + 1);
  if (u >= v) {
    const double se = field.height_m_at_vertex(i + 1, j);
    return sw + (se - sw) * u + (ne - se) * v;
  }
  const double nw = field.height_m_at_vertex(i, j + 1);
  return sw + (nw - sw) * v + (ne - nw) * u;
}

Vec2 nearest_vertex(const Heightfield& field, Vec2 p) {
  const auto [i, j, u, v] = cell_at(field, p);
  return field.vertex(u < 0.5 ? i : i + 1, v < 0.5 ? j : j + 1);
}

Vec3 normal_at(const Heightfield& field, Vec2 p) {
  const auto [i, j, u, v] = cell_at(field, p);
  return unit(slope_normal(field, i, j) * ((1 - u) * (1 - v)) + slope_normal(field, i + 1, j) * (u * (1 - v)) +
              slope_normal(field, i, j + 1) * ((1 - u) * v) + slope_normal(field, i + 1, j + 1) * (u * v));
}

Heightfield window_of(const Heightfield& field, const Box2& box) {
  assert(field.columns >= 2 && field.rows >= 2);
  assert(!box.is_empty());
  const Vec2 min = field.min, step = field.step_m;
  const auto [i0, i1] = window_along(box.min.x, box.max.x, {min.x, step.x, field.columns, field.parts});
  const auto [j0, j1] = window_along(box.min.y, box.max.y, {min.y, step.y, field.rows, field.parts});
  Heightfield window{.min = field.vertex(i0, j0),
                     .step_m = step,
                     .columns = i1 - i0 + 1,
                     .rows = j1 - j0 + 1,
                     .heights = part_of_grid(field.heights, field.columns, {i0, i1}, {j0, j1}),
                     .resampling_error_m = field.resampling_error_m,
                     .parts = field.parts};
  // one sample more on every side, which the field's samples have too
  const auto of_samples = [&](Lines lines) { return Lines{lines.first / field.parts, lines.last / field.parts + 2}; };
  if (field.parts > 1)
    window.samples = part_of_grid(field.samples, field.sample_columns(), of_samples({i0, i1}), of_samples({j0, j1}));
  return window;
}

}  // namespace citykiln::map

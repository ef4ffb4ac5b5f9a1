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
  // one vertex more than normals need on every side
  const auto first = [](double low, double start, double step, int count) {
    return std::clamp(static_cast<int>(std::floor((low - start) / step)) - 1, 0, count - 2);
  };
  const auto last = [](double high, double start, double step, int count) {
    return std::clamp(static_cast<int>(std::ceil((high - start) / step)) + 1, 1, count - 1);
  };
  const Vec2 min = field.min, step = field.step_m;
  const int i0 = first(box.min.x, min.x, step.x, field.columns), j0 = first(box.min.y, min.y, step.y, field.rows);
  const int i1 = std::max(i0 + 1, last(box.max.x, min.x, step.x, field.columns));
  const int j1 = std::max(j0 + 1, last(box.max.y, min.y, step.y, field.rows));
  Heightfield window{.min = field.vertex(i0, j0),
                     .step_m = step,
                     .columns = i1 - i0 + 1,
                     .rows = j1 - j0 + 1,
                     .heights = {},
                     .resampling_error_m = field.resampling_error_m};
  for (int j = j0; j <= j1; ++j) {
    const auto row = field.heights.begin() + static_cast<std::ptrdiff_t>(j) * field.columns;
    window.heights.insert(window.heights.end(), row + i0, row + i1 + 1);
  }
  return window;
}

}  // namespace citykiln::map

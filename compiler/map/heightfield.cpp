#include "compiler/map/heightfield.h"

#include <algorithm>
#include <cmath>

namespace citykiln::map {
namespace {

// The square that holds a point, and where in it, 0 to 1. Points outside are moved to the rim.
struct InSquare {
  int i, j;
  double u, v;
};

InSquare square_at(const Heightfield& field, Vec2 p) {
  const double x = std::clamp((p.x - field.min.x) / field.step_m, 0.0, field.columns - 1.0);
  const double y = std::clamp((p.y - field.min.y) / field.step_m, 0.0, field.rows - 1.0);
  const int i = std::min(static_cast<int>(x), field.columns - 2), j = std::min(static_cast<int>(y), field.rows - 2);
  return {i, j, x - i, y - j};
}

// Of the surface at a vertex, by centred differences (one-sided on the rim).
Vec3 slope_normal(const Heightfield& field, int i, int j) {
  const int west = std::max(i - 1, 0), east = std::min(i + 1, field.columns - 1);
  const int south = std::max(j - 1, 0), north = std::min(j + 1, field.rows - 1);
  const double dx =
      (field.height_m_at_vertex(east, j) - field.height_m_at_vertex(west, j)) / ((east - west) * field.step_m);
  const double dy =
      (field.height_m_at_vertex(i, north) - field.height_m_at_vertex(i, south)) / ((north - south) * field.step_m);
  return unit(Vec3{-dx, -dy, 1});
}

}  // namespace

double height_m_at(const Heightfield& field, Vec2 p) {
  const auto [i, j, u, v] = square_at(field, p);
  const double sw = field.height_m_at_vertex(i, j), ne = field.height_m_at_vertex(i + 1, j + 1);
  if (u >= v) {
    const double se = field.height_m_at_vertex(i + 1, j);
    return sw + (se - sw) * u + (ne - se) * v;
  }
  const double nw = field.height_m_at_vertex(i, j + 1);
  return sw + (nw - sw) * v + (ne - nw) * u;
}

Vec2 nearest_vertex(const Heightfield& field, Vec2 p) {
  const auto nearest = [&](double v, double start) {
    return start + std::floor((v - start) / field.step_m + 0.5) * field.step_m;
  };
  return {nearest(p.x, field.min.x), nearest(p.y, field.min.y)};
}

Vec3 normal_at(const Heightfield& field, Vec2 p) {
  const auto [i, j, u, v] = square_at(field, p);
  return unit(slope_normal(field, i, j) * ((1 - u) * (1 - v)) + slope_normal(field, i + 1, j) * (u * (1 - v)) +
              slope_normal(field, i, j + 1) * ((1 - u) * v) + slope_normal(field, i + 1, j + 1) * (u * v));
}

Heightfield window_of(const Heightfield& field, const Box2& box) {
  // one vertex more than normals ask for on every side
  const auto first = [&](double low, double start, int count) {
    return std::clamp(static_cast<int>(std::floor((low - start) / field.step_m)) - 1, 0, count - 2);
  };
  const auto last = [&](double high, double start, int count) {
    return std::clamp(static_cast<int>(std::ceil((high - start) / field.step_m)) + 1, 1, count - 1);
  };
  const int i0 = first(box.min.x, field.min.x, field.columns), j0 = first(box.min.y, field.min.y, field.rows);
  const int i1 = std::max(i0 + 1, last(box.max.x, field.min.x, field.columns));
  const int j1 = std::max(j0 + 1, last(box.max.y, field.min.y, field.rows));
  Heightfield window{{field.min.x + i0 * field.step_m, field.min.y + j0 * field.step_m},
                     field.step_m,
                     i1 - i0 + 1,
                     j1 - j0 + 1,
                     {},
                     field.resampling_error_m};
  for (int j = j0; j <= j1; ++j) {
    const auto row = field.heights.begin() + static_cast<std::ptrdiff_t>(j) * field.columns;
    window.heights.insert(window.heights.end(), row + i0, row + i1 + 1);
  }
  return window;
}

}  // namespace citykiln::map

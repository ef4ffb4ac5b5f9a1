// Points on a polyline, and parts of a polyline, given by distances along it in metres.
#pragma once

#include <algorithm>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/snap.h"

namespace citykiln {

/// A part of a polyline: the distances of its two ends from the first point, along the polyline.
struct LinePart {
  double from_m = 0, to_m = 0;
};

/// Returns for each point of a polyline its distance from the first point, along the polyline. O(n).
inline std::vector<double> distances_on(const Polyline& line) {
  std::vector<double> along = {0};
  for (std::size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + distance(line[i - 1], line[i]));
  return along;
}

/// Returns the point at a distance along a polyline of two points or more, without equal neighbours. Below 0 and beyond
/// the end, the polyline is continued straight. O(log n).
/// @param along  distances_on(line).
inline Vec2 point_at(const Polyline& line, const std::vector<double>& along, double at_m) {
  const auto next = std::ranges::upper_bound(along, at_m);
  const std::size_t i = std::clamp<std::size_t>(static_cast<std::size_t>(next - along.begin()), 1, line.size() - 1);
  return line[i - 1] + (line[i] - line[i - 1]) * ((at_m - along[i - 1]) / (along[i] - along[i - 1]));
}

/// Returns a part of a polyline as a polyline: its two ends, and the points of the line between them. O(n).
/// @param along  distances_on(line).
inline Polyline points_of(const Polyline& line, const std::vector<double>& along, const LinePart& part) {
  Polyline points = {point_at(line, along, part.from_m)};
  for (std::size_t i = 0; i < line.size(); ++i)
    if (along[i] > part.from_m && along[i] < part.to_m) points.push_back(line[i]);
  points.push_back(point_at(line, along, part.to_m));
  return points;
}

/// Returns the points rounded to the grid of 2⁻¹⁰ m, without equal neighbours; perhaps one point only. O(n).
inline Polyline snapped_line(const Polyline& points) {
  Polyline line;
  for (const Vec2 p : points)
    if (const Vec2 on_grid = snapped(p); line.empty() || line.back() != on_grid) line.push_back(on_grid);
  return line;
}

}  // namespace citykiln

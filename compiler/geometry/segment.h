// Nearest points on segments, polylines and rings, and crossings of segments.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "compiler/geometry/vec.h"

namespace citykiln {

/// Returns the share s in 0 … 1 for which a + s (b - a) is the point of the segment a b nearest to p. 0 if a == b.
template <typename Vec>
double nearest_share(Vec a, Vec b, Vec p) {
  const Vec along = b - a;
  const double squared = dot(along, along);
  return squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
}

/// Returns the point of the segment from a to b that is nearest to p.
template <typename Vec>
Vec nearest_point(Vec a, Vec b, Vec p) {
  return a + (b - a) * nearest_share(a, b, p);
}

/// Returns the distance of p from the segment from a to b.
template <typename Vec>
double distance_to_segment(Vec a, Vec b, Vec p) {
  return length(p - nearest_point(a, b, p));
}

/// Returns the distance of p from a polyline; infinity if it has no segment. O(n).
inline double distance_to_polyline(std::span<const Vec2> polyline, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
    least = std::min(least, distance_to_segment(polyline[i], polyline[i + 1], p));
  return least;
}

/// Returns the distance of p from the border of a ring; infinity if it has no vertex. O(n).
inline double distance_to_ring(std::span<const Vec2> ring, Vec2 p) {
  if (ring.empty()) return std::numeric_limits<double>::infinity();
  return std::min(distance_to_polyline(ring, p), distance_to_segment(ring.back(), ring.front(), p));
}

/// Returns the shares along a b and along c d at which two segments cross; nothing if they do not, or are parallel.
inline std::optional<std::pair<double, double>> crossing_shares(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double area = cross(b - a, d - c);
  if (area == 0) return std::nullopt;
  const double s = cross(c - a, d - c) / area, t = cross(c - a, b - a) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return std::pair(s, t);
}

}  // namespace citykiln

// Axis-parallel boxes of the plane.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "compiler/geometry/vec.h"

namespace citykiln {

/// A closed box. The default is empty; grow() extends it.
struct Box2 {
  Vec2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  bool operator==(const Box2&) const = default;

  bool is_empty() const { return min.x > max.x || min.y > max.y; }
  double width() const { return max.x - min.x; }
  double height() const { return max.y - min.y; }
  Vec2 centre() const { return (min + max) * 0.5; }
  bool contains(Vec2 p) const { return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y; }
  /// True if p is in the box and not on its eastern or northern side. Each point is in one box of a tiling.
  bool contains_half_open(Vec2 p) const { return min.x <= p.x && p.x < max.x && min.y <= p.y && p.y < max.y; }
  bool touches(const Box2& o) const {
    return min.x <= o.max.x && o.min.x <= max.x && min.y <= o.max.y && o.min.y <= max.y;
  }
  void grow(Vec2 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  Box2 widened(double by_m) const { return {{min.x - by_m, min.y - by_m}, {max.x + by_m, max.y + by_m}}; }
};

inline Box2 box_of(std::span<const Vec2> points) {
  Box2 box;
  for (const Vec2 p : points) box.grow(p);
  return box;
}

/// The box of the segment from a to b.
inline Box2 box_of_segment(Vec2 a, Vec2 b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

}  // namespace citykiln

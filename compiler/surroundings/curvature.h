// The Earth's curve beyond the extent, which itself is flat in the plane.
#pragma once

#include <algorithm>

#include "compiler/geometry/box.h"

namespace citykiln::surroundings {

/// The mean radius of the Earth (IUGG), and the coefficient of refraction of surveyors: light bends by this share of
/// the curve (Gauss's mean of the lower air).
inline constexpr double kEarth_m = 6371009, kRefraction = 0.13;

/// How far land at a distance lies below the plane, as light shows it: d² (1 - k) / 2R, 246 m at 60 km.
inline double drop_m(double distance_m) { return distance_m * distance_m * (1 - kRefraction) / (2 * kEarth_m); }

/// The distance between a place and a box; 0 inside.
inline double away_m(const Box2& box, Vec2 p) {
  return length(
      Vec2{std::max({box.min.x - p.x, 0.0, p.x - box.max.x}), std::max({box.min.y - p.y, 0.0, p.y - box.max.y})});
}

}  // namespace citykiln::surroundings

// The Earth's curvature beyond the extent. The extent itself is flat.
#pragma once

#include <algorithm>

#include "compiler/geometry/box.h"

namespace citykiln::surroundings {

/// The mean radius of the Earth (IUGG), and the surveyors' coefficient of refraction: the curvature of light rays
/// divided by the Earth's curvature (Gauss's mean of the lower air).
inline constexpr double kEarth_m = 6371009, kRefraction = 0.13;

/// Returns the apparent drop of land below the plane at a distance d, refraction included: d² (1 - k) / 2R, 246 m at 60
/// km.
inline double drop_m(double distance_m) { return distance_m * distance_m * (1 - kRefraction) / (2 * kEarth_m); }

/// Returns the distance between a place and a box; 0 inside.
inline double away_m(const Box2& box, Vec2 p) {
  return length(
      Vec2{std::max({box.min.x - p.x, 0.0, p.x - box.max.x}), std::max({box.min.y - p.y, 0.0, p.y - box.max.y})});
}

}  // namespace citykiln::surroundings

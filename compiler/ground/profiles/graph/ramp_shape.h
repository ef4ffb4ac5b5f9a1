// The shape of ramps: rounded at the crest and at the foot, and never steeper than the straight ramp.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace citykiln::ground {

/// The heights over which the crest of a ramp and its foot are rounded.
inline constexpr double kCrest_m = 1, kFoot_m = 0.5;

inline constexpr double kFar_m = std::numeric_limits<double>::infinity();

/// Returns how far a ramp with a round crest has dropped where the straight ramp of the same grade has dropped by
/// `cost_m`.
inline double drop_m(double cost_m) {
  if (cost_m <= 0) return 0;
  return cost_m < kCrest_m ? cost_m * cost_m / (2 * kCrest_m) : cost_m - kCrest_m / 2;
}

/// Returns the greater of two heights, rounded where they are nearly equal. Along a way, the result is never steeper
/// than the steeper one of both.
inline double soft_max(double a, double b) {
  const double h = std::max(kFoot_m - std::abs(a - b), 0.0) / kFoot_m;
  return std::max(a, b) + h * h * kFoot_m / 4;
}

}  // namespace citykiln::ground

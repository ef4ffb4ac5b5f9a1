// Points of the unit circle by turns, which are shares of a full circle.
#pragma once

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// Returns the cosine (x) and sine (y) of an angle of `turn` full circles, in [0, 1]. Largest error 2e-8, enough for
/// sampled directions. About three times as fast as the C library.
inline Vec2 on_circle(double turn) {
  // the angle from the nearest quarter, in [-π/4, π/4]
  const int quarter = static_cast<int>(turn * 4 + 0.5);
  const double a = (turn * 4 - quarter) * 1.5707963267948966, a2 = a * a;
  const double sine = a * (1 + a2 * (-1.0 / 6 + a2 * (1.0 / 120 + a2 * (-1.0 / 5040 + a2 / 362880))));
  const double cosine = 1 + a2 * (-0.5 + a2 * (1.0 / 24 + a2 * (-1.0 / 720 + a2 * (1.0 / 40320 - a2 / 3628800))));
  switch (quarter & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace citykiln::preview

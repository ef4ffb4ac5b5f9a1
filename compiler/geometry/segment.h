// Nearest points on segments.
#pragma once

#include <algorithm>

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

}  // namespace citykiln

// The tree line: how woods become sparse with altitude. A belt is the altitude that has the same climate at 42.5° of
// latitude (Habitat::belt_m).
#pragma once

#include <algorithm>

namespace citykiln::plants {

/// The belt of the tree line. Trees become lower up to it (height_factor()).
inline constexpr double kTreeLine_m = 2350;

/// The belts between which the density of woods falls linearly from 1 to kSparseWood. The tree line is between them:
/// above it stand the few trees of kSparseWood.
inline constexpr double kDenseUpTo_m = 2100, kSparseFrom_m = 2500, kSparseWood = 0.15;

/// Returns the density of woods at a belt, as a share of the density in the valley.
inline double wood_share_at(double belt_m) {
  const double up = (belt_m - kDenseUpTo_m) / (kSparseFrom_m - kDenseUpTo_m);
  return 1 - (1 - kSparseWood) * std::clamp(up, 0.0, 1.0);
}

}  // namespace citykiln::plants

// Where woods end, by the altitude of the same climate at 42.5° of latitude (Habitat::belt_m).
#pragma once

#include <algorithm>

namespace citykiln::plants {

/// Belts between which the density of woods falls to kSparseWood, the share at the tree line.
inline constexpr double kDenseUpTo_m = 2100, kSparseFrom_m = 2500, kSparseWood = 0.15;

/// The density of woods as a share of that in the valley.
inline double wood_share_at(double belt_m) {
  const double up = (belt_m - kDenseUpTo_m) / (kSparseFrom_m - kDenseUpTo_m);
  return 1 - (1 - kSparseWood) * std::clamp(up, 0.0, 1.0);
}

}  // namespace citykiln::plants

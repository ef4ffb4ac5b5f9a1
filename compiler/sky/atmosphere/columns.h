// How much air is between a place and the outside.
#pragma once

#include <vector>

#include "compiler/sky/atmosphere/bands.h"

namespace citykiln::sky {

/// The cosine of the zenith angle at which the sea's horizon is seen; <= 0.
double horizon_cosine(double height_m);

/// The share of the sun's disk (or the moon's) above the horizon, 0 to 1, by the cosine of its middle's zenith angle.
double disk_share(double height_m, double cos_zenith);

/// The way along a ray until it leaves the air, or meets the sea.
/// @param height_m  0 to kTop_m.
double way_m(double height_m, double cos_zenith);

/// Columns of air from a place to the outside.
class ColumnTable {
 public:
  explicit ColumnTable(const Air& air);
  /// Within 1 % of the integral. Below the horizon it is that of the horizon. O(1).
  Columns at(double height_m, double cos_zenith) const;

 private:
  std::vector<Columns> cells_;  // rows of heights; finer near the ground, and near the horizon
};

}  // namespace citykiln::sky

// The columns of air along a ray (the integral of the air's density over its length) from a place to outside of the
// atmosphere.
#pragma once

#include <vector>

#include "compiler/sky/atmosphere/bands.h"

namespace citykiln::sky {

/// Returns the cosine of the zenith angle of the sea's horizon, seen from a height above sea level; <= 0.
double horizon_cosine(double height_m);

/// Returns the share of the disk of sun or moon that is above the horizon, 0 to 1.
/// @param cos_zenith  The cosine of the zenith angle of the disk's middle.
double disk_share(double height_m, double cos_zenith);

/// Returns the distance at which a ray leaves the air or meets the sea.
/// @param height_m    0 to kTop_m.
/// @param cos_zenith  The cosine of the zenith angle of the ray's direction.
double way_m(double height_m, double cos_zenith);

/// A table of the columns of air from a place to outside of the atmosphere.
class ColumnTable {
 public:
  explicit ColumnTable(const Air& air);
  /// Returns the columns along a ray, within 1 % of the integral; below the horizon, the columns at the horizon. O(1).
  Columns at(double height_m, double cos_zenith) const;

 private:
  std::vector<Columns> cells_;  // rows of heights; finer near the ground, and near the horizon
};

}  // namespace citykiln::sky

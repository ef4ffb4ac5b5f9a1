// The amount of air along a ray from a place to outside of the atmosphere.
#pragma once

#include <vector>

#include "compiler/sky/atmosphere/bands.h"

namespace citykiln::sky {

/// The cosine of the zenith angle of the sea's horizon; <= 0.
double horizon_cosine(double height_m);

/// The share of the disk of sun or moon that is above the horizon, 0 to 1, by the cosine of the zenith angle of its
/// middle.
double disk_share(double height_m, double cos_zenith);

/// The distance at which a ray leaves the air or meets the sea.
/// @param height_m  0 to kTop_m.
double way_m(double height_m, double cos_zenith);

/// A table of the columns of air from a place to outside of the atmosphere.
class ColumnTable {
 public:
  explicit ColumnTable(const Air& air);
  /// The columns along a ray, within 1 % of the integral. Below the horizon they are those of the horizon. O(1).
  Columns at(double height_m, double cos_zenith) const;

 private:
  std::vector<Columns> cells_;  // rows of heights; finer near the ground, and near the horizon
};

}  // namespace citykiln::sky

// Light from everywhere as a picture.
#pragma once

#include <vector>

namespace citykiln::preview {

/// Radiance by direction, row by row from the zenith to the nadir, rows at equal angles. The middle of a row is east,
/// left of it (towards smaller columns) is north: as seen from inside.
struct EnvironmentMap {
  int width = 0, height = 0;
  std::vector<float> rgb;  ///< Linear, finite, at least 0.
};

}  // namespace citykiln::preview

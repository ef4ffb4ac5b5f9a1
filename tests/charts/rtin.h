// Right-triangulated irregular networks (RTIN), for comparison.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::charts {

/// A square of heights: 2^power cells and 2^power + 1 samples a side, in rows from south to north, each from west to
/// east.
struct HeightSquare {
  int power = 0;                  ///< At least 0.
  double step_m = 0;              ///< Distance between neighbouring samples.
  std::vector<double> heights_m;  ///< samples_per_side()² values.

  int samples_per_side() const { return (1 << power) + 1; }
  double at(int column, int row) const {
    return heights_m[static_cast<std::size_t>(row) * samples_per_side() + column];
  }
};

/// Returns the number of triangles of an RTIN of the square. A triangle is split at the middle of its longest edge if
/// the edge's height there differs from the sample by more than the tolerance of that sample, or if a split below it
/// requires it; so the network has no cracks. Only these differences are bounded, not the distance of every sample from
/// the surface. O(samples).
/// @param tolerance_m  From a sample (x column, y row; whole numbers) to the allowed difference in metres, above 0.
/// Source: Evans, Kirkpatrick, Townsend, "Right-triangulated irregular networks", Algorithmica 30, 2001.
std::int64_t rtin_triangle_count(const HeightSquare& square, const std::function<double(Vec2)>& tolerance_m);

}  // namespace citykiln::charts

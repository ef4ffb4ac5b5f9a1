// Right-triangulated irregular networks (RTIN), for comparison.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::charts {

/// A square of heights with 2^power cells a side, row by row from the south-west corner.
struct HeightSquare {
  int power = 0;
  double step_m = 0;
  std::vector<double> heights_m;

  int count() const { return (1 << power) + 1; }
  double at(int column, int row) const { return heights_m[static_cast<std::size_t>(row) * count() + column]; }
};

/// Returns the triangles of the coarsest network whose every middle of a longest edge that is not a vertex deviates by
/// at most the tolerance of its place, as do all middles below it. The network has no cracks. O(samples).
/// @param tolerance_m  From a place in samples (column, row) to metres.
/// Source: Evans, Kirkpatrick, Townsend, "Right-triangulated irregular networks", Algorithmica 30, 2001.
std::int64_t rtin_triangles(const HeightSquare& square, const std::function<double(Vec2)>& tolerance_m);

}  // namespace citykiln::charts

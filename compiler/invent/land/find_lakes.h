// Hollows of a lattice that hold lakes.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/invent/land/lattice.h"

namespace citykiln::invent {

/// A hollow, filled up to its outlet.
struct Lake {
  std::vector<std::uint32_t> points;  ///< Points under water, ascending.
  std::vector<double> beds_m;         ///< The height of the ground at each of them.
  double level_m = 0;
  Polygon shore;
};

/// Returns the largest hollows, at most `count`, that are at least 2 m deep and 4,000 m² large and lie within a square
/// of this side about the middle. O(n log n).
std::vector<Lake> find_lakes(const Lattice& lattice, int count, double square_side_m);

}  // namespace citykiln::invent

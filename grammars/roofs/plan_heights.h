// The heights of the corners of a plan.
#pragma once

#include <array>
#include <vector>

#include "grammars/roofs/plan_cells.h"

namespace citykiln::roofs {

struct PlanHeights {
  std::vector<std::array<double, 3>> corners_m;  ///< By cell and corner, multiples of 2^-10 m.
  double uncovered_m2 = 0;                       ///< The area of the uncovered cells.
  double largest_gap_m = 0;                      ///< The largest difference between facets of one surface at a point.
};

/// Each point gets the height of the lowest facet of its surface in a covered cell there, else in an uncovered cell,
/// else 0. Over the footprint heights are at least 0, and on its border those below flush_m are 0. O(n log n).
PlanHeights plan_heights(const PlanCells& plan, std::span<const Facet> facets, double flush_m);

}  // namespace citykiln::roofs

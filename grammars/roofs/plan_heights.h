// Computes the heights of a roof at the corners of its plan.
#pragma once

#include <array>
#include <vector>

#include "grammars/roofs/plan_cells.h"

namespace citykiln::roofs {

struct PlanHeights {
  std::vector<std::array<double, 3>> corners_m;  ///< By cell and corner, multiples of 2^-10 m.
  double uncovered_m2 = 0;                       ///< The area of uncovered cells.
  double largest_gap_m = 0;                      ///< The largest difference between facets of one surface at a point.
};

/// Returns one height for each point and surface: that of the surface's lowest facet in the covered cells at the point,
/// else in the uncovered cells, else 0. Heights over the footprint are at least 0; on its border, heights below flush_m
/// become 0. O(n log n).
PlanHeights plan_heights(const PlanCells& plan, std::span<const Facet> facets, double flush_m);

}  // namespace citykiln::roofs

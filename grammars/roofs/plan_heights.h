// How high each corner of a roof's plan is lifted.
#pragma once

#include <array>
#include <vector>

#include "grammars/roofs/plan_cells.h"

namespace citykiln::roofs {

struct PlanHeights {
  std::vector<std::array<double, 3>> corners_m;  ///< By cell and corner, multiples of 2^-10 m.
  double uncovered_m2 = 0;                       ///< Area of the bare cells.
  double largest_gap_m = 0;                      ///< Most by which facets of one sheet differ where they meet.
};

/// Every point takes the lowest facet of its sheet that covers a cell there; where none does, the lowest that bare
/// cells took; 0 without any. Over the footprint it is at least 0, and on its border what is below flush_m is 0. O(n
/// log n).
PlanHeights plan_heights(const PlanCells& plan, std::span<const Facet> facets, double flush_m);

}  // namespace citykiln::roofs

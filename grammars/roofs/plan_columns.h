// Upright lines over the corners of a roof's plan, one a fan of cells: where a footprint touches itself in a point,
// each of its corners there has its own, so that the body touches itself and no more.
#pragma once

#include <array>
#include <vector>

#include "grammars/roofs/plan_cells.h"

namespace citykiln::roofs {

struct PlanColumns {
  std::vector<Vec2> places;
  std::vector<std::array<std::uint32_t, 3>> of_corners;  ///< By cell and corner, into places.
};

/// Corners of cells share a column where cells around one point hang together by edges. O(n α(n)).
PlanColumns plan_columns(const PlanCells& plan);

}  // namespace citykiln::roofs

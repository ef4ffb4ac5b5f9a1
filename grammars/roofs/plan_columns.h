// Columns: vertical lines over the points of a plan, one for each fan of cells. Where a footprint touches itself in a
// point, each fan has a column of its own, so the body touches itself there without sharing a vertex.
#pragma once

#include <array>
#include <vector>

#include "grammars/roofs/plan_cells.h"

namespace citykiln::roofs {

struct PlanColumns {
  std::vector<Vec2> positions;
  std::vector<std::array<std::uint32_t, 3>> of_corners;  ///< By cell and corner: index into positions.
};

/// Finds the columns. Corners at one point share a column if their cells are connected by edges there. O(n α(n)).
PlanColumns plan_columns(const PlanCells& plan);

}  // namespace citykiln::roofs

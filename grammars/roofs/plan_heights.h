// Computes the heights of a roof at the corners of its plan. The plan is divided into cells (triangles) and facets
// (pieces over which the roof is planar); an uncovered cell lies outside of all facets and has the facet of a
// neighbour. Facets with equal Facet::surface meet in height; between two surfaces there may be a wall.
#pragma once

#include <array>
#include <vector>

#include "grammars/roofs/plan_cells.h"

namespace citykiln::roofs {

/// The heights of all corners of cells, and measures of the misfit of facets.
struct PlanHeights {
  /// By cell and corner: height over the eaves plane, a multiple of 2^-10 m.
  std::vector<std::array<double, 3>> corners_m;
  double uncovered_m2 = 0;   ///< The area of uncovered cells.
  double largest_gap_m = 0;  ///< The largest height difference at a point between facets of one surface.
};

/// Returns the heights of all corners. Corners of one surface at one point get one height: the lowest of the surface's
/// facets in the covered cells at the point; without covered cells, the lowest in the uncovered cells; 0 without a
/// facet. Over the footprint, heights below 0 become 0. O(n log n).
/// @param flush_m  On the border of the footprint, heights below this become 0, so that the roof meets the wall.
PlanHeights plan_heights(const PlanCells& plan, std::span<const Facet> facets, double flush_m);

}  // namespace citykiln::roofs

// Triangulates the plan of a roof: the overlay of footprint, eaves and facets (pieces over which the roof is planar). A
// cell is a triangle of the result.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/triangles/delaunay.h"
#include "grammars/roofs/facet.h"

namespace citykiln::roofs {

/// The index of a facet where there is none.
inline constexpr std::uint32_t kNoFacet = 0xffffffffu;

/// A triangle of the plan.
struct PlanCell {
  std::array<std::uint32_t, 3> points{};      ///< Indices into PlanCells::points, counter-clockwise.
  std::array<std::uint32_t, 3> neighbours{};  ///< The cell opposite to each point; kNoFace outside.
  std::uint32_t facet = kNoFacet;  ///< The index of the first facet that covers the cell, else of a neighbour's facet.
  bool is_uncovered = false;       ///< No facet covers the cell.
  bool is_over_footprint = true;   ///< False for a cell below overhanging eaves, outside of the footprint.
};

struct PlanCells {
  std::vector<Vec2> points;  ///< Plane metres, multiples of 2^-10 m; some are unused.
  std::vector<PlanCell> cells;
};

/// Triangulates the union of footprint and eaves so that no border of these or of a facet crosses a triangle. Cannot
/// fail: the arrangement is snap-rounded (arrangement.h) and its triangulation exact. An uncovered cell gets the facet
/// of the nearest covered cell, counted in steps from cell to cell, or kNoFacet if no cell is covered.
/// @param eaves_outline  The outline of overhanging eaves; empty: no overhang.
PlanCells plan_cells(const Polygon& footprint, const Polygon& eaves_outline, std::span<const Facet> facets);

}  // namespace citykiln::roofs

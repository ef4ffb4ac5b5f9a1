// Triangulates the plan of a roof: the overlay of footprint, eaves and facets.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/delaunay.h"
#include "compiler/geometry/polygon.h"
#include "grammars/roofs/facet.h"

namespace citykiln::roofs {

inline constexpr std::uint32_t kNoFacet = 0xffffffffu;

/// A triangle of the plan.
struct PlanCell {
  std::array<std::uint32_t, 3> points{};      ///< Counter-clockwise.
  std::array<std::uint32_t, 3> neighbours{};  ///< The cell opposite to each point; kNoFace outside.
  std::uint32_t facet = kNoFacet;             ///< The first facet that covers it, else a neighbour's.
  bool is_uncovered = false;                  ///< No facet covers it.
  bool is_over_footprint = true;              ///< Else it lies below overhanging eaves only.
};

struct PlanCells {
  std::vector<Vec2> points;  ///< On the 2^-10 m grid; some are unused.
  std::vector<PlanCell> cells;
};

/// Triangulates the union of footprint and eaves so that no border of these or of a facet crosses a triangle. Cannot
/// fail: the arrangement is snap-rounded (arrangement.h) and its triangulation exact. An uncovered cell gets the facet
/// of the nearest covered cell, counted in steps from cell to cell; kNoFacet if no cell is covered.
PlanCells plan_cells(const Polygon& footprint, const Polygon& eaves_outline, std::span<const Facet> facets);

}  // namespace citykiln::roofs

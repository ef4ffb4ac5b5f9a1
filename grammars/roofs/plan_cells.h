// Triangulates the floor plan of a roof: footprint and facets laid over each other.
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
  std::array<std::uint32_t, 3> neighbours{};  ///< Opposite to each point; kNoFace outside.
  std::uint32_t facet = kNoFacet;             ///< The first that covers it, else that of a neighbour.
  bool is_uncovered = false;                  ///< No facet covers it.
  bool is_over_footprint = true;              ///< Else only the eaves are over it.
};

struct PlanCells {
  std::vector<Vec2> points;  ///< On the 2^-10 m grid; some are unused.
  std::vector<PlanCell> cells;
};

/// Triangulates the union of footprint and eaves, so that no border of these or of a facet crosses a triangle. The
/// arrangement is snap-rounded (arrangement.h) and its triangulation exact, so it cannot fail. Uncovered cells get the
/// facet of the nearest covered cell, in steps from cell to cell; kNoFacet without covered cells.
PlanCells plan_cells(const Polygon& footprint, const Polygon& eaves_outline, std::span<const Facet> facets);

}  // namespace citykiln::roofs

// The plan of a roof in triangles: footprint and facets laid over each other.
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
  std::array<std::uint32_t, 3> neighbours{};  ///< Opposite to each point; kNoFace: outside.
  std::uint32_t facet = kNoFacet;             ///< The first that covers it; else one next to it.
  bool is_uncovered = false;                  ///< No facet covers it.
  bool is_over_footprint = true;              ///< Else only the eaves are over it.
};

struct PlanCells {
  std::vector<Vec2> points;  ///< On the 2^-10 m grid; some are unused.
  std::vector<PlanCell> cells;
};

/// Triangles that cover what footprint or eaves cover; no facet's border and no footprint's runs through one. The
/// arrangement is snapped (arrangement.h) and its triangulation exact, so nothing can fail. Cells that no facet covers
/// take that of the cell through which they are first reached, from all covered ones in step; kNoFacet where there is
/// none.
PlanCells plan_cells(const Polygon& footprint, const Polygon& eaves_outline, std::span<const Facet> facets);

}  // namespace citykiln::roofs

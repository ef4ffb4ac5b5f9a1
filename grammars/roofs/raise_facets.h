// Raises the facets of a plan to a closed roof. roofs.md explains why the result is always closed.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/roof.h"

namespace citykiln::roofs {

struct RoofPlan {
  std::vector<Facet> facets;  ///< Over the footprint and the eaves. Where they overlap, the first applies.
  Polygon eaves_outline;      ///< Contains the footprint without touching it; empty: no overhang.
  double thickness_m = 0;     ///< The thickness of overhanging eaves, by which the roof is lifted.
  double flush_m = 0x1p-7;    ///< Heights on the border below this become 0.
};

/// A roof, and measures of the misfit of its facets.
struct RaisedRoof {
  Roof roof;
  double uncovered_m2 = 0;   ///< The area without a facet, over which the facets beside it are extended.
  double largest_gap_m = 0;  ///< The largest height difference between facets of one surface where they meet.
};

/// Overlays facets and footprint, triangulates them, and lifts every vertex to the lowest facet that meets there.
///
/// @param footprint  Any rings: the even-odd rule applies.
/// Guarantees: roof, eaves and floor are closed (roof.h) for any facets; no height is below 0 over the footprint; no
/// vertex of the footprint moves; other vertices are within 2^-10 m of the lines that cross there. O(n log n) for
/// facets spread over the footprint.
RaisedRoof raise_facets(const Polygon& footprint, const RoofPlan& plan);

}  // namespace citykiln::roofs

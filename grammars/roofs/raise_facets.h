// Raises the facets of a plan to a closed roof. A facet is a piece of the plan over which the roof is planar. roofs.md
// explains why the result is always closed.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/roof.h"

namespace citykiln::roofs {

/// The plan of a roof: the facets, and the overhanging eaves.
struct RoofPlan {
  std::vector<Facet> facets;  ///< Facets over the footprint and the eaves. Where facets overlap, the first one applies.
  Polygon eaves_outline;      ///< Contains the footprint without touching it; empty: no overhang.
  double thickness_m = 0;     ///< The thickness of overhanging eaves, by which the roof is lifted.
  /// Heights below this on the border of the footprint become 0, so that the roof meets the wall.
  double flush_m = 0x1p-7;
};

/// A roof, and measures of the misfit of its facets.
struct RaisedRoof {
  Roof roof;
  double uncovered_m2 = 0;   ///< The area without a facet, over which the facets beside it are extended.
  double largest_gap_m = 0;  ///< The largest height difference between facets of one surface where they meet.
};

/// Overlays facets and footprint, triangulates the plan, and lifts every vertex to the lowest facet that meets there.
///
/// @param footprint  Any rings: the even-odd rule applies.
/// Guarantees: roof, eaves and floor are closed (roof.h) for any facets; no height is below 0 over the footprint; no
/// vertex of the footprint moves; other vertices are within 2^-10 m of the lines that cross there. O(n log n) for
/// facets spread over the footprint.
RaisedRoof raise_facets(const Polygon& footprint, const RoofPlan& plan);

}  // namespace citykiln::roofs

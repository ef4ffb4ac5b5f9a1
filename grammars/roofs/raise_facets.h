// Raises a plan of facets to a roof. See roofs.md for why the product closes.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/roof.h"

namespace citykiln::roofs {

/// What is raised.
struct RoofPlan {
  std::vector<Facet> facets;  ///< Over all of the footprint, and over the eaves. Where they overlap the first holds.
  Polygon eaves_outline;      ///< Around the footprint and nowhere touching it; no points: no eaves stand out.
  double thickness_m = 0;     ///< Of eaves that stand out; they lift the roof by it.
  double flush_m = 0x1p-7;    ///< Over the border, roofs less high than this lie on the eaves plane.
};

/// A roof, and how well its facets fitted.
struct RaisedRoof {
  Roof roof;
  double uncovered_m2 = 0;   ///< Of the plan that no facet covers: it goes on as what is next to it.
  double largest_gap_m = 0;  ///< Most by which facets of one sheet differ in height where they meet.
};

/// Lays facets and footprint over each other, triangulates, and lifts every vertex to the lowest facet that meets
/// there.
///
/// @param footprint  Any rings; what is inside of an odd number of them is roofed.
/// Guarantees: roof, eaves and floor close (roof.h), whatever facets are given; no height is below 0 over the
/// footprint; no vertex of the footprint moves; others lie within 2^-10 m of the lines that cross there. Total. O(n log
/// n) for facets spread over the footprint.
RaisedRoof raise_facets(const Polygon& footprint, const RoofPlan& plan);

}  // namespace citykiln::roofs

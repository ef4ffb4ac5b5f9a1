// Simplifies borders: none moves by more than a tolerance, none crosses another, no face is lost.
//
//        v               v may go if the closed triangle a v b holds no other vertex: then no border can cross a b,
//      /   \             for it would have to end in the triangle, or cross a v or v b.
//   --a     b--
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/ground/cover/border.h"

namespace citykiln::ground {

struct SimplifiedBorders {
  std::vector<Border> borders;  ///< Sorted.
  double error_m = 0;           ///< Hausdorff distance between the borders and the simplified ones, edge by edge.
};

/// Removes vertices of borders, the one with the least error first.
///
/// @param borders      Borders that meet only at their ends, as arrange() makes them.
/// @param tolerance_m  >= 0; at 0 only vertices on straight lines are removed.
/// @param is_pinned    True for vertices that must stay. Vertices on the cell's border also stay, and vertices at which
///                     more or fewer than two borders meet, or where the polygon to the left or right changes.
///
/// Guarantees: error_m <= tolerance_m; there are no new vertices; borders meet only at their ends, and a new one passes
/// no vertex so closely that arrange() would bend it; faces keep their neighbours, and none is lost (a ring keeps three
/// vertices). A function of the set of borders inside the cell, not of their order.
///
/// Proof of the error: the distance to a segment is convex, so for a removed run of border it is largest at a vertex.
/// Since the run goes from one end of the segment to the other, each point of the segment has a point of the run at no
/// larger distance. Runs are stored as their convex hulls.
///
/// Cost: O(n log n) if hulls stay small and vertices are spread evenly. Sources: Visvalingam, Whyatt, "Line
/// generalisation by repeated elimination of points", Cartographic J. 30, 1993 (the order; there by area); Dyken,
/// Daehlen, Sevaldrud, "Simultaneous curve simplification", J. Geographical Systems 11, 2009 (whole sets that keep
/// their topology).
SimplifiedBorders simplify_borders(std::span<const Border> borders, double tolerance_m,
                                   const std::function<bool(GridPoint)>& is_pinned);

}  // namespace citykiln::ground

// Borders with fewer vertices: none moves by more than a tolerance, none crosses another, no face is lost.
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
  double error_m = 0;           ///< Largest distance between a border and what stands for it now, both ways.
};

/// Leaves vertices out, the one with the least error first.
///
/// @param borders      Meet only at their ends (arrange() sees to it).
/// @param tolerance_m  >= 0; at 0 only vertices on straight lines go.
/// @param is_pinned    Says of a vertex that it must stay. Besides these, vertices stay on the cell's border, where not
///                     exactly two borders meet, and where left or right changes.
/// Guarantees: error_m <= tolerance_m, the Hausdorff distance between the borders and what replaced them, edge by edge;
/// all vertices are old ones; borders meet only at their ends, and a new one passes no vertex so closely that arrange()
/// would bend it; the same faces lie about each other, none is lost (a ring keeps three vertices). A function of the
/// set of borders: their order does not count. Nothing outside the cell counts. Error: the distance to a segment is
/// convex, so it is largest at a vertex of what was left out; and as that runs from one end of the segment to the
/// other, all of the segment has a point of it beside it at no larger distance. Runs are kept as their convex hulls.
/// Cost: O(n log n) where hulls stay small and vertices are spread evenly.
/// Sources: Visvalingam, Whyatt, "Line generalisation by repeated elimination of points", Cartographic J. 30, 1993 (the
/// order; there by area); Dyken, Daehlen, Sevaldrud, "Simultaneous curve simplification", J. Geographical Systems 11,
/// 2009 (whole sets that keep their topology).
SimplifiedBorders simplify_borders(std::span<const Border> borders, double tolerance_m,
                                   const std::function<bool(GridPoint)>& is_pinned);

}  // namespace citykiln::ground

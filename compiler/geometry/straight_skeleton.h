// The straight skeleton of a polygon with holes: what its edges sweep when all of them move inward at one speed.
//
//    +-----------+     each edge's face is what it sweeps; over it, the distance to the edge's line
//    |\         /|     is the height of a roof of slope 1
//    | >-------< |
//    |/         \|
//    +-----------+
//
// CGAL does the work; its headers stay in straight_skeleton.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// What CGAL computes new points in. Its decisions are exact in both.
enum class SkeletonKernel : std::uint8_t {
  kInexact,  ///< Doubles: fast; points that lie close together may come out in a wrong order.
  kExact,    ///< Fractions of any length: some ten times slower.
};

/// What one edge sweeps.
struct SkeletonFace {
  Ring ring;  ///< Counter-clockwise, plane metres; from the edge's first point to its second, then around. Not convex.
  std::uint32_t ring_index = 0;  ///< 0: the outer ring, then the holes.
  std::uint32_t edge = 0;        ///< From the ring's point of this number to the next.
};

/// One face an edge, in the order of rings and edges; nothing where CGAL fails (it throws, or leaves an edge out).
///
/// @param polygon  Rings simple and strictly apart: looked at before, exactly (ring_crossing.h).
/// Guarantees: the same bytes for the same polygon. Not guaranteed: that the faces fit together; kInexact has been
/// seen to fail, so whoever calls looks at them. Bad input: nothing. Cost: faster than quadratic for houses, 0.4 s for
/// 400 points. Source: Felkel and Obdržálek 1998, as in CGAL's Straight_skeleton_2.
std::vector<SkeletonFace> straight_skeleton(const Polygon& polygon, SkeletonKernel kernel);

}  // namespace citykiln

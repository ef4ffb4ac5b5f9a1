// The straight skeleton of a polygon with holes: the areas swept by its edges as they move inward at equal speed.
//
//    +-----------+     each face is the area swept by one edge; the height of a
//    |\         /|     roof of slope 1 over it is the distance to the edge's line
//    | >-------< |
//    |/         \|
//    +-----------+
//
// CGAL's headers stay in straight_skeleton.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln {

/// The number type of constructed points. Predicates are exact in both kernels.
enum class SkeletonKernel : std::uint8_t {
  kInexact,  ///< Doubles: fast, but the order of points that lie close together may be wrong.
  kExact,    ///< Rational numbers: about ten times slower.
};

/// The face of one edge.
struct SkeletonFace {
  Ring ring;  ///< Counter-clockwise, plane metres; begins with the edge's two points. Not convex in general.
  std::uint32_t ring_index = 0;  ///< 0: the outer ring, then the holes.
  std::uint32_t edge = 0;        ///< Index of the edge's first point in its ring.
};

/// Returns one face for each edge, in the order of rings and edges. Empty if the rings cross or touch, which is tested
/// exactly (ring_crossing.h), or if CGAL fails (it throws, or misses an edge).
///
/// Guarantees: deterministic. Not guaranteed: that faces cover the polygon without overlap; with kInexact they at times
/// do not, so callers must check them. Cost: less than quadratic for house outlines, 0.4 s for 400 points. Source:
/// Felkel and Obdržálek 1998, as in CGAL's Straight_skeleton_2.
std::vector<SkeletonFace> straight_skeleton(const Polygon& polygon, SkeletonKernel kernel);

}  // namespace citykiln

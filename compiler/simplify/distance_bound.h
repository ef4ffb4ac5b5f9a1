// A bound, not a sample, of the one-sided Hausdorff distance between sets of triangles.
#pragma once

#include <limits>
#include <span>

#include "compiler/simplify/triangle_tree.h"

namespace citykiln::simplify {

struct BoundOptions {
  double precision_m;  ///< > 0. The bound exceeds the distance by no more than this, or is least_m.
  double least_m = 0;  ///< Distances up to this are not told apart, which is faster; the bound is no less.
  /// The search ends at the first point that is farther away than this; the result is then its distance.
  double most_m = std::numeric_limits<double>::infinity();
};

struct DistanceBound {
  double distance_m;
  Vec3 at{};  ///< Where it was found: on `from`, within precision_m of the farthest place; none if it is least_m.
};

/// Returns a bound of the distance of any point of `from` to `to`: infinite where only `to` is empty, least_m where
/// `from` is.
///
/// Guarantee: no point of `from` is farther away, but for the rounding of doubles, to which 2^-20 m are added.
/// Proof: the distance from a convex set is a convex function, so on a triangle its largest value to one triangle of
/// `to` is at a corner; and a point is no farther from `to` than the centroid is, plus its way to the centroid. Each
/// triangle is halved along its longest edge until the smaller of these two bounds is near the centroid's distance.
/// Cost: about one search of the tree for each triangle of `from` and for each square of precision_m that is near the
/// farthest point.
DistanceBound distance_bound(std::span<const Corners> from, const TriangleTree& to, const BoundOptions& options);

inline double distance_bound_m(std::span<const Corners> from, const TriangleTree& to, const BoundOptions& options) {
  return distance_bound(from, to, options).distance_m;
}

}  // namespace citykiln::simplify

// A proven upper bound of the one-sided Hausdorff distance between sets of triangles.
#pragma once

#include <limits>
#include <span>

#include "compiler/simplify/triangle_tree.h"

namespace citykiln::simplify {

/// The precision and the limits of a search.
struct BoundOptions {
  /// > 0. The bound exceeds the distance by at most precision_m + 2^-20 m, unless it is least_m + 2^-20 m.
  double precision_m;
  double least_m = 0;  ///< Lower limit of the bound: no smaller distance is resolved, which is faster.
  /// The search ends at the first point that is farther away than this; the result is then its distance.
  double most_m = std::numeric_limits<double>::infinity();
};

/// A bound, and the place that determines it.
struct DistanceBound {
  double distance_m;
  /// A point of `from` whose distance is within precision_m + 2^-20 m of distance_m; (0, 0, 0) if
  /// least_m decides or a set is empty.
  Vec3 at{};
};

/// Returns an upper bound of the distance from any point of `from` to `to`: least_m if `from` is empty, else infinite
/// if `to` is empty.
///
/// Guarantee: no point of `from` is farther away, unless the result exceeds most_m: the search then stopped. The bound
/// includes 2^-20 m for the rounding of doubles.
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

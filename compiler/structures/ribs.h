// Ribs: straight lines across a span (a bridge or tunnel), each at one distance along its axis. Between neighbouring
// ribs the span's surface is interpolated linearly.
//
//     left    |    |      \         Seen from above. A rib passes through each vertex + of the axis and through each
//     axis    +----o-------+        knot o, a point at which the grade of the height profile changes. At a bend the rib
//     right   |    |       /\       is mitred: it lies on the bisector of the bend.
#pragma once

#include <span>
#include <vector>

#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// A straight line across a span. In plan, its point at the distance left_m to the left of the axis is
/// Rib::at + left_m · Rib::out.
struct Rib {
  Vec2 at;   ///< Point of the axis, in metres on the map plane.
  Vec2 out;  ///< Direction to the left, in plan. Its length is 1 for a rib square to the axis, more for a mitred rib at
             ///< a bend.
  double z_m = 0;      ///< Height of the road at the axis.
  double tilt = 0;     ///< Rise per metre to the left, measured square to the axis.
  double along_m = 0;  ///< Distance from the beginning of the way.
};

/// Returns a point on a rib, in metres on the map plane, snapped to multiples of 2^-10 m.
/// @param left_m  Distance to the left of the axis; negative to the right.
/// @param rise_m  Height above the road at that distance.
Vec3 point_on(const Rib& rib, double left_m, double rise_m);

/// Returns the ribs of a span from its begin to its end: one at each vertex of the axis, mitred, and one at each knot
/// of the profile that is more than 0.25 m from a vertex. An end with SpanEnd::cut_m is cut there, square to the axis.
/// There are at least two ribs, or none if the cuts leave less than 0.25 m of the span. From the axis to an edge a
/// mitred rib is at most twice as long as a rib square to the axis, so sharper bends are bevelled. Two spans that meet
/// in a joint have the same rib there, bit for bit. O(points · knots).
std::vector<Rib> ribs_of(const Span& span);

/// The ribs that remain, and the error of omitting the others.
struct SimplifiedRibs {
  std::vector<Rib> ribs;
  double error_m = 0;  ///< Largest distance of the edge points of omitted ribs from the remaining edges.
};
/// Omits ribs as long as both edges of the span stay within the tolerance. Keeps the first and the last. Method:
/// Douglas, Peucker (1973). O(n²) at worst.
/// @param left_m, right_m  Distances from the axis to the edges, > 0.
/// @param tolerance_m      >= 0.
SimplifiedRibs simplify_ribs(std::span<const Rib> ribs, double left_m, double right_m, double tolerance_m);

}  // namespace citykiln::structures

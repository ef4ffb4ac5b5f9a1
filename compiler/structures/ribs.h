// Ribs: lines across a span, between which its surface is interpolated linearly.
//
//     |   |     \            one at each vertex of the axis, mitred, and one at each knot of the profile
//     +---+-------+
//     |   |     / |
#pragma once

#include <span>
#include <vector>

#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct Rib {
  Vec2 at;             ///< Point of the axis, plane metres.
  Vec2 out;            ///< Direction to the left, per metre from the axis; longer than 1 if the rib is mitred.
  double z_m = 0;      ///< Height of the road at the axis.
  double tilt = 0;     ///< Rise per metre to the left, measured square to the axis.
  double along_m = 0;  ///< Distance from the beginning of the way.
};

/// Returns the point at a distance to the left of the axis along a rib, and at a height above the road. Snapped.
Vec3 point_on(const Rib& rib, double left_m, double rise_m);

/// Returns the ribs of a span from its begin to its end: at least two, or none if SpanEnd::cut_m takes all of it. A
/// mitre is at most twice as long as half the width; sharper bends are bevelled. Spans that meet in a joint have the
/// same rib there, bit for bit. O(points + knots).
std::vector<Rib> ribs_of(const Span& span);

struct SimplifiedRibs {
  std::vector<Rib> ribs;
  double error_m = 0;  ///< Largest distance of the edge points of omitted ribs from the remaining edges.
};
/// Omits ribs as long as both edges stay within the tolerance; keeps the first and the last. Method: Douglas, Peucker
/// (1973). O(n²) at worst.
/// @param left_m, right_m  Distances from the axis to the edges.
SimplifiedRibs simplify_ribs(std::span<const Rib> ribs, double left_m, double right_m, double tolerance_m);

}  // namespace citykiln::structures

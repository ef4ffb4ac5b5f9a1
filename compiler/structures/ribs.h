// Ribs: the lines across a span at which its cross-section is known, from its begin to its end.
//
//     |   |     \            one at each bend of the axis, mitred, and one wherever its height bends; between two of
//     +---+-------+          them everything is straight
//     |   |     / |
#pragma once

#include <span>
#include <vector>

#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct Rib {
  Vec2 at;             ///< Of the axis, plane metres.
  Vec2 out;            ///< To the left, for a metre from the axis: longer than one where the line is mitred.
  double z_m = 0;      ///< Of the road's top on the axis.
  double tilt = 0;     ///< Rise a metre to the left, measured square to the axis.
  double along_m = 0;  ///< From the beginning of the way.
};

/// A place on the rib's line, so far to the left of the axis and above its road. Snapped.
Vec3 point_on(const Rib& rib, double left_m, double rise_m);

/// All ribs of a span, from where it begins to where it ends; at least two, or none where nothing is left of it. A
/// bend's mitre is at most twice as long as the line square to the axis: sharper bends are cut off. Where two spans
/// meet in a joint their ribs there are the same line, to the bit. O(points + knots).
std::vector<Rib> ribs_of(const Span& span);

/// Those that are needed.
struct SimplifiedRibs {
  std::vector<Rib> ribs;
  double error_m = 0;  ///< What was left out lies no farther from the edges of what is left.
};
/// Leaves out ribs where the edges stay within the tolerance of the straight line. The first and the last stay.
/// @param left_m, right_m  From the axis to the edges.
/// O(n²) at worst. Douglas, Peucker (1973).
SimplifiedRibs simplify_ribs(std::span<const Rib> ribs, double left_m, double right_m, double tolerance_m);

}  // namespace citykiln::structures

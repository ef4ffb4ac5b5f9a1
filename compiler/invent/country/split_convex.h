// Splits convex rings along lines.
#pragma once

#include "compiler/geometry/polygon.h"

namespace citykiln::invent {

/// Two parts of a convex ring with a gap between them, and the line in the middle of the gap.
struct SplitConvex {
  Ring left, right;  ///< Convex, counter-clockwise; empty if nothing of the ring lies there.
  Vec2 from, to;     ///< The part of the line in the ring.
};

/// Splits a convex ring along a line.
///
/// @param ring       Counter-clockwise, in metres as the other parameters.
/// @param on_line    A point of the line.
/// @param direction  The line's direction, a unit vector. `left` is on its left side.
/// @param margin_m   Half the gap.
SplitConvex split_convex(const Ring& ring, Vec2 on_line, Vec2 direction, double margin_m);

}  // namespace citykiln::invent

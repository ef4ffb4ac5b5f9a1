// Strips of ground along an axis, as rings.
#pragma once

#include <optional>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// How a strip ends: square, round, or joined by a mitre to the strip that continues there.
struct StripEnds {
  bool has_round_ends = false;
  std::optional<Vec2> before, after;  ///< The adjacent points of the strips that continue at either end.
};

/// The mitre of a bend: what an offset of one metre to the left adds to its point. The offset lines of both segments
/// meet there. @param before, after  Unit directions less than half a turn apart.
inline Vec2 mitre_of(Vec2 before, Vec2 after) {
  return (left_of(before) + left_of(after)) * (1 / (1 + dot(before, after)));
}

/// Returns the strip as overlapping counter-clockwise rings, snapped to 2^-10 m: one quad a segment, a wedge or a disk
/// at each bend, and the ends asked for. The strip is their union (sum of winding numbers not zero). Total. Disks are
/// 16-gons about the circle: their border is off by less than 2 % of the half width. O(n).
/// @param strip  At least two points.
std::vector<Ring> stroke(const Strip& strip, const StripEnds& ends = {});

/// Returns the carriageway within its width limits, as rings like stroke(). Adds a quad wherever an edge bends between
/// two vertices.
std::vector<Ring> stroke_carriageway(const Road& road, const StripEnds& ends = {});

/// Returns the road up to its outermost pavement or cycle track, as rings like stroke_carriageway(), or nothing where
/// it has none. Verges between pavement and kerb are included, verges outside are not.
std::vector<Ring> stroke_pavements(const Road& road, const StripEnds& ends = {});

}  // namespace citykiln::roads

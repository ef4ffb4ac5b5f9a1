// Outlines roads, and strips of ground along an axis, as rings (polygons without holes).
#pragma once

#include <optional>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// The ends of a strip: square, round, or joined by a mitre to the strip that continues there.
struct StripEnds {
  bool has_round_ends = false;        ///< For stroke() only.
  std::optional<Vec2> before, after;  ///< The adjacent points of the strips that continue at either end.
};

/// The mitre of a bend: the vector from its point to the intersection of both segments' lines, each offset by one metre
/// to the left.
/// @param before, after  Unit directions less than half a turn apart.
inline Vec2 mitre_of(Vec2 before, Vec2 after) {
  return (left_of(before) + left_of(after)) * (1 / (1 + dot(before, after)));
}

/// Returns a counter-clockwise ring of 16 points on a circle, snapped to 2^-10 m (kQuantum_m). Its sides lie inside the
/// circle by less than 2 % of the radius.
Ring sixteen_gon(Vec2 centre, double radius_m);

/// Returns the strip as overlapping counter-clockwise rings, in plane metres snapped to 2^-10 m: one quad per segment,
/// one ring at each bend, and the ends. A bend of less than a right angle has a wedge, filled to the mitre; a sharper
/// one has a disk, a sixteen_gon(). The strip is the rings' union (sum of winding numbers not zero). O(n).
///
/// @param strip  At least two points.
std::vector<Ring> stroke(const Strip& strip, const StripEnds& ends = {});

/// Returns the carriageway within its width limits, as rings like stroke(). Adds a quad wherever an edge bends between
/// two vertices.
std::vector<Ring> stroke_carriageway(const Road& road, const StripEnds& ends = {});

/// Returns the road up to its outermost pavement or cycle track, as rings like stroke_carriageway(); nothing if it has
/// none. Verges between pavement and kerb are included, verges outside are not.
std::vector<Ring> stroke_pavements(const Road& road, const StripEnds& ends = {});

}  // namespace citykiln::roads

// From an axis to the strip of ground it covers.
#pragma once

#include <optional>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// How a strip ends: square; round; or with the joint of a bend, where another strip goes on towards a point.
struct StripEnds {
  bool are_round = false;
  std::optional<Vec2> from, to;  ///< Before the first point of the axis, after the last.
};

/// The strip as overlapping counter-clockwise rings: one quad a segment, a wedge or a disk at each bend, ends as asked
/// for. Their union (where the sum of winding numbers is not zero) is the strip; it needs no union to be computed and
/// has no case that fails. Vertices are snapped to 2^-10 m; disks are 16-gons about the circle (border error under 2 %
/// of the half width). O(n).
std::vector<Ring> stroke(const Strip& strip, const StripEnds& ends = {});

/// What lies between the road's kerbs, narrowed where buildings stand, likewise: a quad a segment, and one more
/// wherever an edge bends beside it.
std::vector<Ring> stroke_carriageway(const Road& road, const StripEnds& ends = {});

/// The road out to its outermost pavement or cycle track, likewise; empty where it has none. What lies between this and
/// the carriageway is pavement, verges within it and all; verges farther out are not in it.
std::vector<Ring> stroke_pavements(const Road& road, const StripEnds& ends = {});

}  // namespace citykiln::roads

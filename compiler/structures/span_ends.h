// Finds the ends of bridges and tunnels: on the ground, at another span, or free.
#pragma once

#include <vector>

#include "compiler/map/features.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct SpanEnds {
  SpanEnd from, to;
};

/// Returns the ends of each track that leaves the ground, in the order of features.tracks.
///
/// Counts only tracks of the same family (streets, paths, rails) that have a node at the span's end.
/// - kJoint: exactly one other span of the same passage (bridge or tunnel), at more than a right angle to this one. If
///   several spans meet, or the angle is smaller, all are kFree.
/// - kGround: no other span, and exactly one road on the ground, at more than a right angle.
/// - kBesideRoad: other roads on the ground. The cut is 0 if only tracks of other families are there.
/// - kFree: all other ends. Ends do not depend on the order of tracks. O(n log n) in vertices.
std::vector<SpanEnds> find_ends(const map::Features& features);

}  // namespace citykiln::structures

// Finds how bridges and tunnels end: on the ground, at another bridge or tunnel, or free. A span is one bridge or
// tunnel.
#pragma once

#include <vector>

#include "compiler/map/features.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

/// Both ends of a span.
struct SpanEnds {
  SpanEnd from, to;
};

/// Returns the ends of each track that leaves the ground, in the order of features.tracks.
///
/// Only tracks of the span's family (streets, paths or rails) that have a map node at the span's end count:
/// - kJoint: exactly one other span of the same passage (bridge or tunnel) ends there, at more than a right angle to
///   this span. If several spans meet there, or the angle is smaller, all of them are kFree.
/// - kGround: no other span ends there, and exactly one road on the ground does, at more than a right angle.
/// - kBesideRoad: other roads on the ground. SpanEnd::cut_m is 0 if only tracks of other families are there.
/// - kFree: all other ends.
///
/// The result does not depend on the order of tracks. O(n log n) in vertices.
std::vector<SpanEnds> find_ends(const map::FeatureView& features);

}  // namespace citykiln::structures

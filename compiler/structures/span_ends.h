// How bridges and tunnels end: on the ground, at each other, or freely.
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
/// Tracks continue each other if they share a node and are of one family (streets, paths, rails). Two spans of one
/// passage that meet alone, at more than a right angle between them, form a joint; if more meet, all are cut square. If
/// one road continues on the ground, the span ends square to it; if a road passes, at that road's edge. Ends that touch
/// only tracks of other families are square at the node. The result does not depend on the order of tracks. Total. O(n
/// log n) in vertices.
std::vector<SpanEnds> find_ends(const map::Features& features);

}  // namespace citykiln::structures

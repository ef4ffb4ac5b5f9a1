// How bridges and tunnels end: on the ground, in each other, or nowhere.
#pragma once

#include <vector>

#include "compiler/map/features.h"
#include "compiler/structures/recipe.h"

namespace citykiln::structures {

struct SpanEnds {
  SpanEnd from, to;
};

/// The ends of each track that leaves the ground, in the order of features.tracks.
///
/// Ways go on into each other where they share a node of the map: streets into streets, paths into paths, rails into
/// rails. Two spans of one passage that alone meet there, at less than a right angle, are a joint; where more meet all
/// are cut square. Where one road goes on, on the ground, the span ends square to it; where a road passes it is cut
/// where that road's edge is. A path that meets a road, and all else that only touches, ends square at the node. Does
/// not depend on the order of tracks. Total. O(n log n) in vertices.
std::vector<SpanEnds> find_ends(const map::Features& features);

}  // namespace citykiln::structures

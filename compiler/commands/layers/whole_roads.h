// Joins the pieces of roads in the chunks of a manifest (the recipes of one tile each) to whole roads.
#pragma once

#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Returns the roads on the ground of all chunks, each once. Pieces of one road that overlap or meet become one, with
/// the points, width limits and profile of all. If a part of a road is in no chunk, the road becomes several with one
/// id, in order along it. Sorted by id. Cannot fail. O(n log n).
std::vector<roads::Road> whole_roads(const scene::Scene& scene);

}  // namespace citykiln::commands

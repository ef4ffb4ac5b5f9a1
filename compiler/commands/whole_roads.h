// The roads of a manifest, put together again from the pieces that its chunks hold.
#pragma once

#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Returns the roads on the ground of all chunks, each once: pieces of one road that overlap or meet become one, with
/// the points, width limits and profile of all. A road of which a part is in no chunk is several roads of one id, in
/// order. Sorted by id. Total. O(n log n).
std::vector<roads::Road> whole_roads(const scene::Scene& scene);

}  // namespace citykiln::commands

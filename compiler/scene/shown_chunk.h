// The recipes of a chunk that its tile shows.
#pragma once

#include <memory>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// True if tiles show all recipes of a chunk as they are: shown_chunk() would return the chunk unchanged.
bool shows_recipes_as_they_are(const Shown& shown);

/// Returns a chunk whose woods have the density of Header::shown, none at 0 and at most plants::kMostTreesPerHa, and
/// without yards and what they generate where yards are left out. Other layers are left out when a tile is baked: what
/// stands in them still bars others from its place. O(n log n).
Chunk shown_chunk(const Header& header, const Chunk& chunk);

/// Returns shown_chunk(), or without a copy the chunk itself, which must then outlive the result.
std::shared_ptr<const Chunk> shared_shown_chunk(const Header& header, const Chunk& chunk);

}  // namespace citykiln::scene

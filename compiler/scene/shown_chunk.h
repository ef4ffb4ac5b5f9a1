// The recipes of a chunk that its tile shows.
#pragma once

#include <memory>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// True if tiles show all recipes of a chunk as they are: shown_chunk() would return the chunk unchanged.
bool shows_recipes_as_they_are(const Shown& shown);

/// Returns a chunk with Header::shown applied to its recipes. The densities of woods are multiplied by
/// Shown::wood_density, and limited to the range from plants::kLeastTreesPerHa to plants::kMostTreesPerHa (or the
/// wood's own density, if that is larger); 0 removes the woods. Yards and the recipes made for them are removed if
/// their layer is left out. Other layers are left out when the tile is baked, since their objects still keep others
/// from their place. O(n log n).
Chunk shown_chunk(const Header& header, const Chunk& chunk);

/// Returns shown_chunk(), or without a copy the chunk itself, which must then outlive the result.
std::shared_ptr<const Chunk> shared_shown_chunk(const Header& header, const Chunk& chunk);

}  // namespace citykiln::scene

// Leaves out of a chunk what its yards draw, and draws it again: a manifest holds recipes of yards only.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// A chunk without most surfaces, barriers and trees of its yards.
struct LeanChunk {
  Chunk chunk;
  /// For each of chunk.yards the features that it draws but the whole chunk does not have: true for these, in the order
  /// surfaces, barriers, trees. A chunk lacks objects that another tile has, and holds trimmed surfaces as they are.
  /// Missing values at the end are false.
  std::vector<std::vector<bool>> left_out{};
};

/// Returns the chunk without those surfaces, barriers and trees that are equal to what its yards draw.
/// @param seed  Header::seed.
/// Guarantee: drawn(lean(chunk, seed), seed) == chunk. O(n log n).
LeanChunk lean(const Chunk& chunk, std::uint64_t seed);

/// Returns the chunk with what its yards draw, each list sorted by id as far as it was before. Accepts any lean chunk.
Chunk drawn(LeanChunk&& lean, std::uint64_t seed);

}  // namespace citykiln::scene

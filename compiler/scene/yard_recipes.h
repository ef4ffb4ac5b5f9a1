// Takes the generated objects of yards out of a chunk, and generates them again: a manifest holds recipes of yards
// only.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// A chunk without those surfaces, barriers and trees that its yards generate.
struct StrippedChunk {
  Chunk chunk;
  /// For each of chunk.yards a flag for each object that it generates, in the order surfaces, barriers, trees: true if
  /// restore_yards() must not add it. It belongs to another tile, or it was trimmed or changed and is in `chunk` as it
  /// was. Missing values at the end are false.
  std::vector<std::vector<bool>> suppressed{};
};

/// Returns the chunk without the objects that equal what its yards generate.
/// @param seed  Header::seed.
/// Guarantee: restore_yards(strip_yards(chunk, seed), seed) == chunk, also for chunks whose lists are not sorted, which
/// keep all objects. O(n log n).
StrippedChunk strip_yards(const Chunk& chunk, std::uint64_t seed);

/// Returns the chunk with the objects that its yards generate, merged by id. Accepts any yards and flags. O(n log n).
/// @param stripped  Is consumed.
Chunk restore_yards(StrippedChunk&& stripped, std::uint64_t seed);

}  // namespace citykiln::scene

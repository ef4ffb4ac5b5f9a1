// The streams of the land around the extent (MANIFEST.md, Surroundings).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/surroundings/recipe.h"

namespace citykiln::exporters {

struct SurroundingsStreams {
  std::vector<std::uint8_t> x, y, heights, covers;
};

/// @param around  Not empty.
SurroundingsStreams encode_surroundings(const surroundings::Surroundings& around);

/// Reads lines, heights and covers, which may be unsound; nothing where a stream ends early or late, or has more lines
/// than surroundings::kMostLines. Memory: in proportion to the streams.
std::optional<surroundings::Surroundings> decode_surroundings(std::span<const std::uint8_t> x,
                                                              std::span<const std::uint8_t> y,
                                                              std::span<const std::uint8_t> heights,
                                                              std::span<const std::uint8_t> covers);

}  // namespace citykiln::exporters

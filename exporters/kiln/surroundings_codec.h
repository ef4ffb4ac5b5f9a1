// Encodes the land around the extent as four streams, and decodes it (MANIFEST.md, Surroundings).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/surroundings/recipe.h"

namespace citykiln::exporters {

/// The streams: positions of the grid's columns and rows, heights, and classes of land cover.
struct SurroundingsStreams {
  std::vector<std::uint8_t> x, y, heights, covers;
};

/// @param around  Not empty.
/// Returns the land around the extent as streams.
SurroundingsStreams encode_surroundings(const surroundings::Surroundings& around);

/// Decodes the four streams. Returns std::nullopt if a stream ends early or late, or there are more lines than
/// surroundings::kMostLines. Does not check values: see surroundings::is_sound(). Memory: proportional to the streams.
std::optional<surroundings::Surroundings> decode_surroundings(std::span<const std::uint8_t> x,
                                                              std::span<const std::uint8_t> y,
                                                              std::span<const std::uint8_t> heights,
                                                              std::span<const std::uint8_t> covers);

}  // namespace citykiln::exporters

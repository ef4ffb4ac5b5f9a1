// Encodes a chunk of the scene (the recipes of one tile) as named streams, and decodes it. A stream has the values of
// one property.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// The bytes of each stream that is not empty, by name.
using Streams = std::map<std::string, std::vector<std::uint8_t>>;

/// Returns the names of all streams in the order of a chunk. The order is part of the format: new names are appended.
std::span<const char* const> stream_names();

/// Encodes a chunk; of its yards the recipes alone, where what they draw is in the chunk. Lossless for coordinates that
/// are multiples of 2^-10 m.
/// @param seed  scene::Header::seed, from which yards are drawn.
Streams encode_chunk(const scene::Chunk& chunk, std::uint64_t seed);

/// Decodes a chunk. Returns std::nullopt, and sets `wrong` to the name of the stream, if a stream is missing, too short
/// or too long, or holds a value that no chunk can have (an unknown enumerator, a grid of the wrong size, an axis of
/// one point).
/// @param seed  The one with which the chunk was encoded.
std::optional<scene::Chunk> decode_chunk(const Streams& streams, scene::TileKey tile, std::uint64_t seed,
                                         std::string& wrong);

}  // namespace citykiln::exporters

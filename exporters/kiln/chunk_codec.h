// A chunk of the scene as named streams, and back.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/scene/scene.h"

namespace citykiln::exporters {

using Streams = std::map<std::string, std::vector<std::uint8_t>>;

/// The names of all streams, in the order in which a chunk holds them. Part of the format: add at the end.
std::span<const char* const> stream_names();

/// Lossless for coordinates that are multiples of 2^-10 m.
Streams encode_chunk(const scene::Chunk& chunk);

/// Nothing where a stream is missing, too short or too long, or says what no chunk can be (an enumerator that does not
/// exist, a grid of the wrong size, an axis of one point, a height that is not finite). `wrong` then names the stream.
std::optional<scene::Chunk> decode_chunk(const Streams& streams, scene::TileKey tile, std::string& wrong);

}  // namespace citykiln::exporters

// The manifest (.kiln): the scene as a file, in the format of MANIFEST.md. It has a header and one zstd frame per
// chunk, so a tile can be read without the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// Encodes a scene. Deterministic, and lossless for scenes that compile() makes, whose numbers are on the grids of the
/// format: decode_manifest(encode_manifest(scene, threads), name, {}) == scene.
std::vector<std::byte> encode_manifest(const scene::Scene& scene, int threads);

/// Decodes a manifest. Errors: bytes that are not a complete manifest of this major version. No bytes make the function
/// crash (fuzzed).
/// @param name  The name of the file in error messages.
/// @param only  If not empty, only the chunks of these tiles are decoded; a missing tile is an error.
Result<scene::Scene> decode_manifest(std::span<const std::byte> bytes, const std::string& name,
                                     std::span<const scene::TileKey> only);

/// Checks the header and the index of an encoded manifest, not its chunks, with the errors of decode_manifest() for
/// these. Writers call it before they write. Cost: unpacks the header.
Result<Done> check_header(std::span<const std::byte> bytes, const std::string& name);

/// Hashes all properties of a header, or all recipes (planned objects of one tile) of a chunk. The hash does not depend
/// on the other chunks of the scene. Cost: as encoding without compression.
std::uint64_t hash_of(const scene::Header& header);
std::uint64_t hash_of(const scene::Chunk& chunk, std::uint64_t seed);

/// The bytes of one stream (the values of one property) over all chunks of a scene.
struct StreamSize {
  const char* name;
  std::uint64_t raw_bytes;     ///< Before compression.
  std::uint64_t packed_bytes;  ///< The sum over the chunks of the stream packed alone, without a dictionary. All
                               ///< streams together usually exceed the manifest's frames, which pack streams together.
};
/// Returns the streams that are not empty, in the order of a chunk. Cost: as encode_manifest(), on one thread.
std::vector<StreamSize> stream_sizes_of(const scene::Scene& scene);

/// Reads a scene from a file, with the errors of decode_manifest().
/// @param only   If not empty, only the chunks of these tiles are read; a missing tile is an error.
Result<scene::Scene> read_manifest(const std::string& path, std::span<const scene::TileKey> only);

}  // namespace citykiln::exporters

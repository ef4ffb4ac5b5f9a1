// The manifest, .kiln: the scene as a file, in the format of MANIFEST.md. It has a header and one zstd frame per chunk,
// so that one tile can be read without the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// Same scene, same bytes. Lossless: decode_manifest(encode_manifest(scene)) == scene.
std::vector<std::byte> encode_manifest(const scene::Scene& scene, int threads);

/// Decodes a manifest. Errors: anything but a whole manifest of this major version; never a crash, whatever the bytes
/// (fuzzed).
/// @param name  The file's name in error messages.
/// @param only  If not empty, only these tiles' chunks are decoded; a missing tile is an error.
Result<scene::Scene> decode_manifest(std::span<const std::byte> bytes, const std::string& name,
                                     std::span<const scene::TileKey> only);

/// Hashes of all properties of a header and of all recipes of a chunk: equal for equal values, whatever other chunks
/// the scene has. Cost: that of encoding it without compression.
std::uint64_t hash_of(const scene::Header& header);
std::uint64_t hash_of(const scene::Chunk& chunk);

Result<Done> write_manifest(const scene::Scene& scene, const std::string& path, int threads);
Result<scene::Scene> read_manifest(const std::string& path, std::span<const scene::TileKey> only);

}  // namespace citykiln::exporters

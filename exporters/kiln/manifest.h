// The manifest, .kiln: the scene written down. Format: MANIFEST.md. A header, and one zstd frame a chunk, so that a
// tile is read without the rest.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// Same scene, same bytes. Lossless: decode(encode(scene)) == scene.
std::vector<std::byte> encode_manifest(const scene::Scene& scene, int threads);

/// @param name  How errors call the bytes, e.g. the file's name.
/// @param only  If not empty, only these tiles' chunks are decoded; a tile that is not there is an error.
/// Errors: anything that is not a whole manifest of this major version: never a crash, whatever the bytes (fuzzed).
Result<scene::Scene> decode_manifest(std::span<const std::byte> bytes, const std::string& name,
                                     std::span<const scene::TileKey> only);

Result<Done> write_manifest(const scene::Scene& scene, const std::string& path, int threads);
Result<scene::Scene> read_manifest(const std::string& path, std::span<const scene::TileKey> only);

}  // namespace citykiln::exporters

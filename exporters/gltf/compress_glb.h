// From a plain .glb to one whose meshes are packed, and back.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "exporters/gltf/compression.h"
#include "exporters/gltf/glb_parts.h"

namespace citykiln::exporters {

/// @param plain  As encode_glb writes one: an accessor, and it a buffer view, for each attribute. Its places and uvs
///               lie on the grids of packed meshes (quantise.h), or stay unpacked numbers.
/// Meshes are packed on their own, on at most `threads` threads; pictures, tables and instances stay as they are. Same
/// input, same bytes, for any number of threads.
std::vector<std::byte> compressed_glb(GlbParts plain, Compression compression, int threads);

/// The plain .glb, with attributes in single precision; nothing where no mesh is packed.
/// @param bytes  Two chunks that fill the file. Throws a std::exception where what is packed is not what it says.
std::optional<std::vector<std::byte>> decompressed_glb(std::span<const std::byte> bytes);

}  // namespace citykiln::exporters

// Packs the meshes of a plain .glb, and unpacks them again.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "compiler/contract/compression.h"
#include "exporters/gltf/glb_parts.h"

namespace citykiln::exporters {

/// Returns a file with packed meshes. Images, tables and instances stay as they are. Same bytes for any number of
/// threads.
/// @param plain  As encode_glb writes it: each attribute has an accessor with a buffer view of its own. Positions and
///              uvs on the grids of packed meshes (quantise.h) stay exact.
/// @param compression  Not kNone.
GlbParts compressed_glb(GlbParts plain, Compression compression, int threads);

/// Returns the plain .glb, with attributes in single precision; nothing where no mesh is packed. Throws a
/// std::exception where packed data are invalid.
/// @param bytes  As expect_chunks() has accepted them.
std::optional<std::vector<std::byte>> decompressed_glb(std::span<const std::byte> bytes);

}  // namespace citykiln::exporters

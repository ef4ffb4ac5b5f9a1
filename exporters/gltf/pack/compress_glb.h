// Packs the meshes of a plain .glb, and unpacks them again.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "compiler/contract/system/compression.h"
#include "exporters/gltf/glb_parts.h"

namespace citykiln::exporters {

/// Returns a .glb with packed meshes. Images and tables stay as they are; without Draco, nodes, instances and textures
/// are scaled by the steps of 16 bit attributes (narrow_attributes.h). The bytes do not depend on the number of
/// threads.
/// @param plain  The output of build_glb(): each attribute has an accessor with a buffer view of its own. Positions and
///              uvs on the grids of packed meshes (quantise.h) stay exact.
/// @param compression  Not kNone.
GlbParts compressed_glb(GlbParts plain, Compression compression, int threads);

/// Returns the plain .glb, with attributes in single precision; std::nullopt if no mesh is packed. Throws a
/// std::exception if packed data are invalid.
/// @param bytes  A .glb that expect_chunks() has accepted.
std::optional<std::vector<std::byte>> decompressed_glb(std::span<const std::byte> bytes);

}  // namespace citykiln::exporters

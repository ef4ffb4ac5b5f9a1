// Checks of a .glb that must succeed before tinygltf reads it.
#pragma once

#include <cstddef>
#include <span>

namespace citykiln::exporters {

/// Checks that a JSON chunk and a binary chunk fill the file, and that the JSON is not nested too deeply: tinygltf
/// reads up to eight bytes behind a chunk that is slightly too long, and recurses for each bracket. Throws FormatError.
void expect_chunks(std::span<const std::byte> bytes);

/// Checks that images lie in the buffer: tinygltf takes the address of an image's first byte without a check. Throws
/// FormatError.
/// @param bytes  A .glb that expect_chunks() has accepted.
void expect_pictures_inside(std::span<const std::byte> bytes);

}  // namespace citykiln::exporters

// What has to hold of a .glb before tinygltf may see it.
#pragma once

#include <cstddef>
#include <span>

namespace citykiln::exporters {

/// Two chunks that fill the file, and JSON that is not nested too deep: tinygltf reads up to eight bytes behind a chunk
/// that is a little too long, and calls itself for each bracket. Throws FormatError, here and below.
void expect_chunks(std::span<const std::byte> bytes);

/// tinygltf takes the address of a picture's first byte before anyone can ask whether it is in the buffer.
/// @param bytes  As expect_chunks() found them good.
void expect_pictures_inside(std::span<const std::byte> bytes);

}  // namespace citykiln::exporters

// Encodes and decodes texture images as WebP files, for readers that support EXT_texture_webp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"
#include "exporters/gltf/png.h"

namespace citykiln::exporters {

/// Encodes an image with lossy compression.
/// @param quality  1 … 100, of libwebp's scale.
std::vector<std::byte> encode_webp(const materials::TextureImage& image, int quality);

/// Encodes an image with lossless compression. @param opacity  Empty, or one per texel; texels of opacity 0 keep their
/// colour.
std::vector<std::byte> encode_lossless_webp(const materials::TextureImage& image,
                                            std::span<const std::uint8_t> opacity = {});

/// Decodes any WebP that is not an animation. Images without alpha are opaque; texel_m is 0. Errors: anything else, or
/// more texels than an image may have. Never crashes.
/// @param name  The name of the file in error messages.
Result<CutoutImage> decode_webp(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters

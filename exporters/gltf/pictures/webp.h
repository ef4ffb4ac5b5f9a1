// Encodes and decodes texture images as WebP files, for readers that support EXT_texture_webp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"
#include "exporters/gltf/pictures/png.h"

namespace citykiln::exporters {

/// Encodes an image with lossy compression.
/// @param quality  1 … 100, of libwebp's scale.
std::vector<std::byte> encode_webp(const materials::TextureImage& image, int quality);

/// Encodes an image with lossless compression.
/// @param opacity  Empty (opaque), or one per texel, 255 = opaque. The colours of texels with opacity 0 are stored too.
std::vector<std::byte> encode_lossless_webp(const materials::TextureImage& image,
                                            std::span<const std::uint8_t> opacity = {});

/// Decodes any WebP that is not an animation, into colours and opacities. Images without alpha are opaque. A file does
/// not tell the size of a texel in metres, so TextureImage::texel_m is 0. Errors: bytes that are not a WebP image, an
/// animation, or more texels than materials::kMaxImageTexels. Never crashes.
/// @param name  The name of the file in error messages.
Result<CutoutImage> decode_webp(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters

// Encodes and decodes texture images as PNG files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::exporters {

/// Encodes an image in 8-bit sRGB, with a palette if it has at most 256 colours. Deterministic.
/// @param image   Not empty, at most materials::kMaxImageTexels.
std::vector<std::byte> encode_png(const materials::TextureImage& image);

/// Encodes an image with opacities. The colours of texels with opacity 0 are stored too.
/// @param opacity  One per texel, 255 = opaque.
std::vector<std::byte> encode_png(const materials::TextureImage& image, std::span<const std::uint8_t> opacity);

/// Decodes any PNG; transparent texels are blended with black. A file does not tell the size of a texel in metres, so
/// TextureImage::texel_m is 0; all else is equal after encode_png() and decode_png(). Errors: bytes that are not a PNG,
/// damage, or more texels than materials::kMaxImageTexels. Never crashes. Memory: proportional to the file, at most the
/// memory of kMaxImageTexels.
/// @param name  The name of the file in error messages.
Result<materials::TextureImage> decode_png(std::span<const std::byte> bytes, const std::string& name);

/// The colours and opacities of an image.
struct CutoutImage {
  materials::TextureImage colour;
  std::vector<std::uint8_t> opacity;  ///< One per texel.
};
/// Decodes an image and its opacities; images without alpha are opaque. Errors and memory: those of decode_png().
Result<CutoutImage> decode_cutout_png(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters

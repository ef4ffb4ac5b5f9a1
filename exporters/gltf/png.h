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
/// @param image  Not empty, at most materials::kMostTexels.
std::vector<std::byte> encode_png(const materials::TextureImage& image);

/// Encodes an image with an opacity per texel. Texels of opacity 0 keep their colour.
std::vector<std::byte> encode_png(const materials::TextureImage& image, std::span<const std::uint8_t> opacity);

/// Decodes any PNG; transparent texels are blended with black. decode_png(encode_png(image)) == image but for texel_m,
/// which is 0. Errors: not a PNG, damage, or more texels than kMostTexels. Never crashes. Memory: proportional to the
/// file, at most that of kMostTexels.
/// @param name  The name of the file in error messages.
Result<materials::TextureImage> decode_png(std::span<const std::byte> bytes, const std::string& name);

/// An image with opacities.
struct CutoutImage {
  materials::TextureImage colour;
  std::vector<std::uint8_t> opacity;  ///< One per texel.
};
/// Decodes an image and its opacities; images without alpha are opaque.
Result<CutoutImage> decode_cutout_png(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters

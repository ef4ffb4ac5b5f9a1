// Encodes and decodes texture images as JPEG files, for opaque colours. The files have a third of the size of PNG
// files, without visible errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::exporters {

/// The resolution of the two colour components.
enum class JpegChroma : std::uint8_t { kHalf, kFull };

/// Encodes an image: baseline, 8 bit YCbCr.
///
/// @param image  Not empty, at most 65500 texels on a side.
/// @param quality  1 … 100, of libjpeg's scale.
///
/// Guarantees: the bytes do not depend on the CPU, since libjpeg-turbo's vectorised integer transforms are exact.
std::vector<std::byte> encode_jpeg(const materials::TextureImage& image, int quality, JpegChroma chroma);

/// Decodes a baseline JPEG. A file does not tell the size of a texel in metres, so TextureImage::texel_m is 0. Errors:
/// bytes that are not a JPEG, a progressive, damaged or incomplete JPEG, or more texels than
/// materials::kMaxImageTexels. Never crashes. Memory: at most 2^9 texels per byte of the file.
/// @param name  The name of the file in error messages.
Result<materials::TextureImage> decode_jpeg(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters

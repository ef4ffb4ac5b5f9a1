// JPEG files of texture images: opaque colours, a third of the size of PNG, at an error that is not visible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::exporters {

/// Resolution of the two colour components.
enum class JpegChroma : std::uint8_t { kHalf, kFull };

/// Encodes an image: baseline, 8 bit YCbCr.
///
/// @param image    With texels, at most 65500 on a side.
/// @param quality  1 … 100, of libjpeg's scale.
///
/// Guarantees: the same bytes on every CPU: libjpeg-turbo's vectorised integer transforms are exact.
std::vector<std::byte> encode_jpeg(const materials::TextureImage& image, int quality, JpegChroma chroma);

/// Decodes a baseline JPEG; texel_m is 0. Errors: no JPEG, progressive, damaged or cut off, or of more texels than an
/// image may have; never a crash. Memory: at most 2^9 texels for each byte of the file.
/// @param name  The file's name in error messages.
Result<materials::TextureImage> decode_jpeg(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters

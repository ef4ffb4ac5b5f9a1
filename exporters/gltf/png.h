// PNG: the texels of a sheet, as files hold them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/texture_image.h"

namespace citykiln::exporters {

/// Row by row, 8 bit sRGB; with a palette where 256 colours do. Same texels, same bytes.
/// @param sheet  With texels, no more than a sheet may have.
std::vector<std::byte> encode_png(const materials::TextureImage& sheet);

/// The same with an opacity for each texel, which keeps its colour where it is 0.
std::vector<std::byte> encode_png(const materials::TextureImage& sheet, std::span<const std::uint8_t> opacity);

/// decode(encode(sheet)) == sheet, but for texel_m, which is 0. Takes any PNG: what shines through shows black.
/// Errors: what is no PNG, damaged, or has more texels than a sheet may; never a crash. Memory: at most
/// kMaxImageTexels, and in proportion to the file.
Result<materials::TextureImage> decode_png(std::span<const std::byte> bytes, const std::string& name);

/// The same with opacities; what has none is opaque.
struct CutoutImage {
  materials::TextureImage colour;
  std::vector<std::uint8_t> opacity;
};
Result<CutoutImage> decode_cutout_png(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters
